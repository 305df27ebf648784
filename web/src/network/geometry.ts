// A picture of the server (columns and rows of characters) in pixels. A wire runs through the middle of its row.
import type { NetworkShape } from '../connection/protocol';

export const COLUMN = 9;
export const ROW = 20;
export const MARGIN = 8;

export const left = (x: number): number => MARGIN + x * COLUMN;
export const top = (y: number): number => MARGIN + y * ROW;
export const middle = (y: number): number => top(y) + ROW / 2;
const centre = (x: number): number => left(x) + COLUMN / 2;

export interface Rect {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** What a shape takes, in pixels. */
export function rectOf({ kind, x, y, w, h }: NetworkShape): Rect {
  if (kind === 'frame') return { x: left(x), y: middle(y), width: w * COLUMN, height: (h - 1) * ROW };
  return { x: left(x), y: top(y), width: Math.max(w, 1) * COLUMN, height: ROW };
}

export interface Size {
  width: number;
  height: number;
}

export const sizeOf = (picture: { w: number; h: number }): Size => ({
  width: picture.w * COLUMN + 2 * MARGIN,
  height: picture.h * ROW + 2 * MARGIN,
});

export interface Line {
  x1: number;
  y1: number;
  x2: number;
  y2: number;
}

/** Wires at the edges of their columns, or in the middle of the first or last one, where another goes down. */
export function wireLine(shape: NetworkShape): Line {
  const { x, y, w, h } = shape;
  if (w === 0) return { x1: centre(x), y1: middle(y), x2: centre(x), y2: middle(y + h) };
  return {
    x1: shape.ends === 'begins' ? centre(x) : left(x),
    y1: middle(y),
    x2: shape.ends === 'ends' ? centre(x + w - 1) : left(x + w),
    y2: middle(y),
  };
}

/** At the right edge of its column, where wires begin; a short one inside a picture at the left. */
export function railLine({ x, y, h }: NetworkShape): Line {
  const at = left(h > 0 ? x + 1 : x);
  return { x1: at, y1: top(y), x2: at, y2: top(y + h + 1) };
}

const HALF = ROW / 2 - 2;

/** Two strokes, and one across them if it is open while the signal is 1. */
export function contactPath({ x, y, w, text }: NetworkShape): string {
  const from = left(x) + 4;
  const to = left(x + w) - 4;
  const at = middle(y);
  const strokes = `M${from} ${at - HALF}V${at + HALF}M${to} ${at - HALF}V${at + HALF}`;
  return text === '/' ? `${strokes}M${from} ${at + HALF}L${to} ${at - HALF}` : strokes;
}

/** A pair of brackets. */
export function coilPath({ x, y, w }: NetworkShape): string {
  const at = middle(y);
  const bracket = (x: number, bend: number) => `M${x} ${at - HALF}Q${x + bend} ${at} ${x} ${at + HALF}`;
  return bracket(left(x) + 6, -6) + bracket(left(x + w) - 6, 6);
}

/** The wire into a contact or coil and the one out of it, up to its strokes. */
export function stubs({ kind, x, y, w }: NetworkShape): [before: Line, behind: Line] {
  const inset = kind === 'coil' ? 3 : 4;
  const at = middle(y);
  return [
    { x1: left(x), y1: at, x2: left(x) + inset, y2: at },
    { x1: left(x + w) - inset, y1: at, x2: left(x + w), y2: at },
  ];
}

/** Text inside a contact, coil or at its own place: where it stands, and how wide it is. */
export function textAt({ kind, x, y, w, text = '' }: NetworkShape): { x: number; y: number; length: number } {
  const columns = [...text].length;
  const at = kind === 'text' ? x : x + (w - columns) / 2;
  return { x: left(at), y: middle(y) + 5, length: columns * COLUMN };
}
