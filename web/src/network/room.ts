// Where a value of the status is written: beside its operand, over nothing that is drawn if there is room.
import type { NetworkShape } from '../connection/protocol';
import { MARGIN, rectOf, ROW, type Rect } from './geometry';

const HEIGHT = 15;
const CHARACTER = 8;
/** A value that grows by a digit stays where it is. */
const LEAST = 6;
const GAP = 3;

const apart = (a: Rect, b: Rect): boolean =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

export interface Told {
  text: string;
  /** Its operand. */
  beside: Rect;
  /** Of a pin of a box: its side. */
  side?: 'inputOf' | 'outputOf' | undefined;
}

/** Left of a picture with boxes, behind their rail: the values of inputs that have no room before their operand. */
export const ASIDE = 96;

/** Above, behind, below: where nobody reads it as a part of the operand. Values of pins stay in the row of their pin. */
function places({ text, beside: { x, y, width }, side }: Told): Rect[] {
  // The right edge of an input's value stays where it is, so that it needs no room to grow.
  const wide = Math.max(text.length, side === 'inputOf' ? 0 : LEAST) * CHARACTER + 4;
  const at = (x: number, y: number): Rect => ({ x, y, width: wide, height: HEIGHT });
  const level = y + (ROW - HEIGHT) / 2;
  const behind = at(x + width + GAP, level);
  const before = at(x - wide - GAP, level);
  if (side === 'outputOf') return [behind, at(x, y + ROW)];
  if (side === 'inputOf') return [before, at(MARGIN - GAP - wide, level)];
  return [at(x, y - HEIGHT), at(x + width - wide, y - HEIGHT), behind, at(x, y + ROW), before];
}

const isText = ({ kind }: NetworkShape): boolean => kind === 'text' || kind === 'contact' || kind === 'coil';

/** What a line takes. */
function lineRect(shape: NetworkShape): Rect {
  const { x, y, width } = rectOf(shape);
  const down = shape.kind === 'rail' || shape.w === 0;
  if (down) return { x, y: y + ROW / 2, width: 9, height: shape.h * ROW };
  return { x, y: y + ROW / 2 - 2, width, height: 4 };
}

/** Where each value stands. */
export function roomFor(shapes: readonly NetworkShape[], values: readonly Told[]): Rect[] {
  const taken = shapes.filter(isText).map(rectOf);
  const lines = shapes.filter(({ kind }) => kind === 'wire' || kind === 'rail').map(lineRect);
  const frames = shapes.filter(({ kind }) => kind === 'frame').map(rectOf);
  return values.map((told) => {
    const choice = places(told).filter(({ x, y }) => (x >= 0 || told.side === 'inputOf') && y >= 0);
    const free = (over: readonly Rect[]) => choice.find((place) => over.every((one) => apart(place, one)));
    const place = free([...taken, ...lines, ...frames]) ?? free([...taken, ...frames]) ?? free(taken) ?? choice.at(-1)!;
    taken.push(place);
    return place;
  });
}
