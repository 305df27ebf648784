// Which blocks a CALL box can call, which data blocks can be their instances, and how what was typed is spelled in the text.
import type { BlockEntry, Catalogue, SymbolIndex } from '../editor/catalogue';

const id = (typed: string): string => /^(S?F[BC]|DB)\s*(\d+)$/i.exec(typed)?.slice(1).join(' ').toUpperCase() ?? '';

/** "FB 1" of "fb1" and of the name of FB 1. */
const idOf = (typed: string, symbols: SymbolIndex): string =>
  id(symbols.ofName(typed)?.operand.replace(/\s+/g, ' ') ?? typed);

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

export const needsInstance = (typed: string, symbols: SymbolIndex): boolean => /^S?FB /.test(idOf(typed, symbols));

/** The instances of a function block there are, then the first number that is free (its title). */
export function instancesFor(
  typed: string,
  data: readonly BlockEntry[],
  symbols: SymbolIndex,
  title: string,
): BlockEntry[] {
  const block = idOf(typed, symbols);
  const taken = new Set(data.map((one) => one.id));
  let free = 1;
  while (taken.has(`DB ${free}`)) ++free;
  return [...data.filter((one) => one.instanceOf === block), { id: `DB ${free}`, symbol: '', title }];
}

/** A data block may be made later: any number that is free is one. `data` are all there are, `offered` those of the block. */
export function instanceOf(
  typed: string,
  offered: readonly BlockEntry[],
  data: readonly BlockEntry[],
  symbols: SymbolIndex,
): string {
  const own = spelled(typed, offered, symbols);
  return own || spelled(typed, data, symbols) ? own : id(typed).replace(/^(?!DB).*/, '');
}
