// Which blocks a CALL box can call, and how what was typed is spelled in the text.
import type { BlockEntry, Catalogue, SymbolIndex } from '../editor/catalogue';

const id = (typed: string): string => /^(S?F[BC]|DB)\s*(\d+)$/i.exec(typed)?.slice(1).join(' ').toUpperCase() ?? '';

/** Each block once: one of the program stands in the place of the block of the library with its number. */
export function blocksOf({ blocks }: Pick<Catalogue, 'blocks'>, kinds: RegExp): BlockEntry[] {
  const known = new Map<string, BlockEntry>();
  for (const one of blocks) if (kinds.test(one.id) && !known.has(one.id)) known.set(one.id, one);
  return [...known.values()];
}

/** "fc1" is FC 1, a name gets its quotation marks; "#motor" is an instance in the block itself. Empty: there is no such block. */
export function spelled(typed: string, offered: readonly BlockEntry[], symbols: SymbolIndex): string {
  if (/^#\w/.test(typed)) return typed;
  const symbol = symbols.ofName(typed);
  const named = symbol && offered.find((one) => one.id === symbol.operand.replace(/\s+/g, ' '));
  if (named) return `"${symbol.name}"`;
  return offered.find((one) => one.id === id(typed))?.id ?? '';
}

export function needsInstance(typed: string, symbols: SymbolIndex): boolean {
  return /^S?FB\b/i.test((symbols.ofName(typed)?.operand ?? typed).replace(/(\d)/, ' $1'));
}

/** A data block may be made later: any number is one. */
export const instanceOf = (typed: string, offered: readonly BlockEntry[], symbols: SymbolIndex): string =>
  spelled(typed, offered, symbols) || id(typed).replace(/^(?!DB).*/, '');
