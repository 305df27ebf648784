// Symbols that have another name now, and their uses: a text with the old name cannot be compiled any more.
import { sameOperand } from '../editor/mnemonics';
import type { SymbolRow } from './rows';

export interface Renaming {
  from: string;
  to: string;
}

/** Of two states of the table: the operand is what stays. */
export function renamed(before: readonly SymbolRow[], after: readonly SymbolRow[]): Renaming[] {
  const names = new Map(after.map((row) => [sameOperand(row.operand), row.symbol]));
  return before.flatMap(({ symbol, operand }) => {
    const to = operand.trim() === '' ? undefined : names.get(sameOperand(operand));
    return symbol === '' || !to || to.toUpperCase() === symbol.toUpperCase() ? [] : [{ from: symbol, to }];
  });
}

/** All in one pass: of two symbols that change their names each use gets its own. */
export function withNewNames(text: string, renamings: readonly Renaming[]): { text: string; count: number } {
  if (renamings.length === 0) return { text, count: 0 };
  const names = new Map(renamings.map(({ from, to }) => [from.toUpperCase(), to]));
  const uses = new RegExp(`"(${renamings.map(({ from }) => escaped(from)).join('|')})"`, 'gi');
  let count = 0;
  const changed = text.replace(uses, (whole, name: string) => {
    const to = names.get(name.toUpperCase());
    if (to === undefined) return whole;
    count++;
    return `"${to}"`;
  });
  return { text: changed, count };
}

const escaped = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
