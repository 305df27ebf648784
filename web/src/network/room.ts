// Where a value of the status is written: beside its operand, over nothing that is drawn if there is room.
import type { NetworkShape } from '../connection/protocol';
import { rectOf, ROW, type Rect } from './geometry';

const HEIGHT = 15;
const CHARACTER = 8;
/** A value that grows by a digit stays where it is. */
const LEAST = 6;
const GAP = 3;

const apart = (a: Rect, b: Rect): boolean =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

/** Above, behind, below: where nobody reads it as a part of the operand. */
function places({ x, y, width }: Rect, wide: number): Rect[] {
  const at = (x: number, y: number): Rect => ({ x, y, width: wide, height: HEIGHT });
  const level = y + (ROW - HEIGHT) / 2;
  return [
    at(x, y - HEIGHT),
    at(x + width - wide, y - HEIGHT),
    at(x + width + GAP, level),
    at(x, y + ROW),
    at(x - wide - GAP, level),
  ];
}

const isText = ({ kind }: NetworkShape): boolean => kind === 'text' || kind === 'contact' || kind === 'coil';

/** What a line takes. */
function lineRect(shape: NetworkShape): Rect {
  const { x, y, width } = rectOf(shape);
  const down = shape.kind === 'rail' || shape.w === 0;
  if (down) return { x, y: y + ROW / 2, width: 9, height: shape.h * ROW };
  return { x, y: y + ROW / 2 - 2, width, height: 4 };
}

/** `texts` are the values, `beside` their operands: where each stands. */
export function roomFor(shapes: readonly NetworkShape[], values: readonly { text: string; beside: Rect }[]): Rect[] {
  const taken = shapes.filter(isText).map(rectOf);
  const lines = shapes.filter(({ kind }) => kind === 'wire' || kind === 'rail').map(lineRect);
  const frames = shapes.filter(({ kind }) => kind === 'frame').map(rectOf);
  return values.map(({ text, beside }) => {
    const choice = places(beside, Math.max(text.length, LEAST) * CHARACTER + 4).filter(({ x, y }) => x >= 0 && y >= 0);
    const free = (over: readonly Rect[]) => choice.find((place) => over.every((one) => apart(place, one)));
    const place = free([...taken, ...lines, ...frames]) ?? free([...taken, ...frames]) ?? free(taken) ?? choice[0]!;
    taken.push(place);
    return place;
  });
}
