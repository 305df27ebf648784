// A network on paper: one wider than a page goes on below, cut where only wires run.
import type { NetworkShape } from '../connection/protocol';
import { COLUMN, MARGIN, rectOf, type Rect } from './geometry';

/** Pixels on a page: on A4 upright they come down to two thirds, letters of 7 points; smaller nobody reads them. */
export const WIDEST = 1080;

export interface Strip {
  from: number;
  to: number;
}

/** What of a shape stays together: all but wires. */
export function undivided(shape: NetworkShape): Rect[] {
  if (shape.kind === 'wire') return [];
  const rect = rectOf(shape);
  const text = shape.kind === 'text' ? [...(shape.text ?? '')].length * COLUMN : 0;
  return [{ ...rect, width: Math.max(rect.width, text) }];
}

/** The last place at most WIDEST behind `from` that goes through nothing; there is none through a wider box. */
function cutBehind(from: number, whole: readonly Rect[]): number {
  const last = from + WIDEST;
  for (let at = last - ((last - MARGIN) % COLUMN); at > from; at -= COLUMN)
    if (!whole.some(({ x, width }) => x < at && at < x + width)) return at;
  return last;
}

export function stripsOf(width: number, whole: readonly Rect[]): Strip[] {
  const strips: Strip[] = [];
  for (let from = 0; from < width; ) {
    const to = width - from <= WIDEST ? width : cutBehind(from, whole);
    strips.push({ from, to });
    from = to;
  }
  return strips;
}
