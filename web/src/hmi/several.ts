// What is done with several symbols of a picture at once; they are named by their places in the list.
import { GRID, HEIGHT, MOST, onGrid, placed, WIDTH, within, type Item } from './picture';

export type Chosen = readonly number[];
export interface Point {
  x: number;
  y: number;
}

export const chosenOf = (items: readonly Item[], chosen: Chosen): Item[] => chosen.flatMap((at) => items[at] ?? []);

const changed = (items: readonly Item[], chosen: Chosen, change: (item: Item) => Item): Item[] =>
  items.map((item, at) => (chosen.includes(at) ? change(item) : item));

export const toggled = (chosen: Chosen, index: number): number[] =>
  chosen.includes(index) ? chosen.filter((at) => at !== index) : [...chosen, index];

/** All by the same way, as far as the picture reaches: they keep their places to each other. */
export function moved(items: readonly Item[], chosen: Chosen, by: Point): Item[] {
  const some = chosenOf(items, chosen);
  const least = (of: (item: Item) => number) => Math.min(...some.map(of));
  const x = within(
    onGrid(by.x),
    -least((one) => one.x),
    least((one) => WIDTH - one.x - one.width),
  );
  const y = within(
    onGrid(by.y),
    -least((one) => one.y),
    least((one) => HEIGHT - one.y - one.height),
  );
  return changed(items, chosen, (item) => ({ ...item, x: item.x + x, y: item.y + y }));
}

export const resized = (items: readonly Item[], chosen: Chosen, by: Point): Item[] =>
  changed(items, chosen, (item) => placed({ ...item, width: item.width + by.x, height: item.height + by.y }));

/** At the left or upper edge of the one that is furthest there. */
export function aligned(items: readonly Item[], chosen: Chosen, edge: 'x' | 'y'): Item[] {
  const least = Math.min(...chosenOf(items, chosen).map((item) => item[edge]));
  return changed(items, chosen, (item) => ({ ...item, [edge]: least }));
}

export const without = (items: readonly Item[], chosen: Chosen): Item[] =>
  items.filter((_, at) => !chosen.includes(at));

/** Copies beside the originals; what the file says about those stays there. */
export function copies(some: readonly Item[]): Item[] {
  const plain = some.map(({ above: _, ...item }) => item);
  return moved(
    plain,
    plain.map((_, at) => at),
    { x: 2 * GRID, y: 2 * GRID },
  );
}

/** With these in front, and where they are then; none if a picture cannot have so many. */
export function appended(items: readonly Item[], more: readonly Item[]): { items: Item[]; chosen: number[] } | null {
  if (items.length + more.length > MOST) return null;
  return { items: [...items, ...more], chosen: more.map((_, at) => items.length + at) };
}

/** The last one of the list lies in front of the others; among each other they stay as they are. */
export function layered(items: readonly Item[], chosen: Chosen, front: boolean): { items: Item[]; chosen: number[] } {
  const some = items.filter((_, at) => chosen.includes(at));
  const others = without(items, chosen);
  const first = front ? others.length : 0;
  return { items: front ? [...others, ...some] : [...some, ...others], chosen: some.map((_, at) => first + at) };
}

/** Those that lie wholly in the frame of two corners. */
export function enclosed(items: readonly Item[], one: Point, other: Point): number[] {
  const [left, right] = [Math.min(one.x, other.x), Math.max(one.x, other.x)];
  const [top, bottom] = [Math.min(one.y, other.y), Math.max(one.y, other.y)];
  return items.flatMap(({ x, y, width, height }, at) =>
    x >= left && x + width <= right && y >= top && y + height <= bottom ? [at] : [],
  );
}
