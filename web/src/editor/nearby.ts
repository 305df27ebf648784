// The operands around the cursor, for a list of values that follows it: those of its network.
import type { BlockOutline } from './outline';

const comment = /\/\/.*$/;
// A symbol with the way into its data, a local variable, a formal operand of STEP 5, data of a named block, a bit or a wider operand, a
// timer or counter. What stands behind a "#" is a constant: W#16#FFFF, P#M 10.0.
const operand =
  /"[^"]+"(?:\.[A-Za-z_]\w*(?:\[[^\]]*\])?)*|(?<!\w)#[A-Za-z_][\w.]*(?:\[[^\]]*\][\w.]*)*|(?<=\s)=[A-Za-z]\w*|(?<![\w#])DB\s?\d+\.DB(?:X\s*\d+\.[0-7]|[BWD]\s*\d+)|(?<![\w#])[EIAQM]\s*\d+\.[0-7]\b|\b[EIAQM][BWD]\s*\d+\b|\b[TZC]\s+\d+\b/gi;

/** First and last line of the network at the cursor; of the block where it has none. */
export function networkLines(block: BlockOutline, line: number): { first: number; last: number } {
  const before = block.networks.filter((one) => one.line <= line).at(-1) ?? block.networks[0];
  if (!before) return { first: block.line, last: block.end };
  const next = block.networks[block.networks.indexOf(before) + 1];
  return { first: before.line, last: next ? next.line - 1 : block.end };
}

/** How the server is asked for an operand, and by what it is found again. */
const spelled = (written: string): string => written.replace(/\s+/g, written.startsWith('"') ? '$&' : ' ');
export const operandKey = (written: string): string => written.toUpperCase().replace(/\s+/g, '');

/** The operands of one line and where they end; none of a heading, of a comment. */
export function operandsOf(line: string): { written: string; end: number }[] {
  if (/^\s*(TITLE|NETWORK|NETZWERK)\b/i.test(line)) return [];
  const found = line.replace(comment, '').matchAll(operand);
  return [...found].map((match) => ({ written: match[0], end: match.index + match[0].length }));
}

/** That can be asked for: each once, in the order of the text, as it is written. `isBlock`: a symbol that names no value. */
export function operandsIn(lines: readonly string[], isBlock: (symbol: string) => boolean): string[] {
  const found = new Map<string, string>();
  for (const line of lines) {
    for (const { written } of operandsOf(line)) {
      // It is the operand of a call, and another one in the next call.
      if (written.startsWith('=')) continue;
      if (/^"[^"]+"$/.test(written) && isBlock(written)) continue;
      const key = operandKey(written);
      if (!found.has(key)) found.set(key, spelled(written));
    }
  }
  return [...found.values()];
}

/** `U T 5` asks whether it runs: its time or count is not what the statement sees, the status column STA is. */
export const isQueryOfTimer = (text: string, operand: string): boolean =>
  /^\s*(?:\w+\s*:\s*)?(?:[UOXA]N?)\s/i.test(text) && /^[TZC]\s*\d/i.test(operand);
