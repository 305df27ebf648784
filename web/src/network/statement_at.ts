// Which elements of a network a statement belongs to: most statements are none of their own, an element is named by its last.
import { type Item } from './items';

/** Those at exactly this line, counted from the first one of the network; otherwise the one that the statement leads to. */
export function standingAt(items: readonly Item[], line: number): Item[] {
  const shown = items.filter(({ kind }) => kind !== 'field');
  const exact = shown.filter((item) => item.line === line);
  if (exact.length > 0) return exact;
  const later = shown.filter((item) => item.line > line).sort((a, b) => a.line - b.line);
  return later.slice(0, 1);
}

/** The contacts, coils and boxes that a statement is part of: an operand of a box counts as the box. */
export function elementsWith(items: readonly Item[], line: number): ReadonlySet<Item> {
  const boxOf = ({ of }: Item) => items.find(({ kind, node }) => of && kind === 'frame' && node === of.box);
  return new Set(standingAt(items, line).map((item) => boxOf(item) ?? item));
}
