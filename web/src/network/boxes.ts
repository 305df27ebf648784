// The pins of a box, as they are walked and filled: the inputs from top to bottom, then the outputs.
import { missing, NO_PIN, same, type Direction, type Item } from './items';

const height = ({ rect }: Item): number => rect.y + rect.height / 2;

export function pinsOf(items: readonly Item[], box: number): Item[] {
  const side = (item: Item) => (item.of?.side === 'outputOf' ? 1 : 0);
  return items.filter(({ of }) => of?.box === box).sort((a, b) => side(a) - side(b) || height(a) - height(b));
}

const isFrame = ({ kind, pin }: Item): boolean => kind === 'frame' && pin === NO_PIN;

/** Where an arrow key leads within a box; undefined: out of it. */
export function withinBox(items: readonly Item[], from: Item, direction: Direction): Item | undefined {
  if (isFrame(from)) return direction === 'down' ? pinsOf(items, from.node)[0] : undefined;
  if (!from.of) return undefined;
  const { box, side } = from.of;
  const pins = pinsOf(items, box);
  const at = pins.findIndex((pin) => same(pin, from));
  if (direction === 'down') return pins[at + 1];
  if (direction === 'up') return pins[at - 1] ?? items.find((item) => isFrame(item) && item.node === box);
  if (side !== (direction === 'right' ? 'inputOf' : 'outputOf')) return undefined;
  const away = (item: Item) => Math.abs(height(item) - height(from));
  return pins.filter(({ of }) => of?.side !== side).sort((a, b) => away(a) - away(b))[0];
}

/** What lies outside of a box, or of the box of a pin. */
export function outside(items: readonly Item[], from: Item, direction: Direction): readonly Item[] {
  const box = from.of?.box ?? (isFrame(from) && direction === 'up' ? from.node : undefined);
  if (box === undefined) return items;
  return items.filter((item) => item.of?.box !== box && !(isFrame(item) && item.node === box));
}

const isOpen = (item: Item): boolean => missing(item.operand) || (item.kind === 'field' && item.pin > 0);

/** The next open pin of a call, behind this pin or behind the name of its block; undefined: none, or no call. */
export function nextPin(items: readonly Item[], from: Pick<Item, 'node' | 'field'>): Item | undefined {
  const here = items.find(({ node, field, of }) => node === from.node && field === from.field && of);
  const box = here?.of?.box ?? from.node;
  if (!items.some((item) => isFrame(item) && item.node === box && item.calls)) return undefined;
  const pins = pinsOf(items, box);
  return pins.slice(here ? pins.indexOf(here) + 1 : 0).find(isOpen);
}

/** Of the elements at a line with a problem, those it is about: what is missing, otherwise all but open pins. */
export const blamedAt = (items: readonly Item[], wrong: (item: Item) => boolean): ReadonlySet<Item> => {
  const there = items.filter((item) => wrong(item) && item.kind !== 'field');
  const gaps = new Set(there.filter(({ operand }) => missing(operand)).map(({ line }) => line));
  return new Set(there.filter(({ line, operand }) => !gaps.has(line) || missing(operand)));
};
