// The way with the arrow keys: along the wire, at the edge of a network on to the next one.
import type { NetworkPicture } from '../connection/protocol';
import { outside, withinBox } from './boxes';
import { inOrder, itemsOf, next, type Direction, type Item } from './items';

export interface Step {
  network: number;
  /** null: the heading of the network. */
  item: Item | null;
}

const stepIn = (items: readonly Item[], from: Item, direction: Direction): Item | undefined =>
  withinBox(items, from, direction) ?? next(outside(items, from, direction), from, direction);

/** `from`: where the selection is in `network`; undefined: there is nothing in this direction. */
export function stepFrom(
  list: readonly NetworkPicture[],
  network: number,
  from: Item | null,
  direction: Direction,
): Step | undefined {
  const itemsIn = (number: number): Item[] => inOrder(itemsOf(list.find((one) => one.number === number)?.shapes ?? []));
  const onwards = direction === 'right' || direction === 'down';
  const items = itemsIn(network);
  const to = from ? stepIn(items, from, direction) : onwards ? items[0] : undefined;
  if (to) return { network, item: to };
  if (from && !onwards) return { network, item: null };
  const other = onwards ? network + 1 : network - 1;
  if (!list.some((one) => one.number === other)) return undefined;
  return { network: other, item: onwards ? null : (itemsIn(other).at(-1) ?? null) };
}
