/** Where the belt begins and ends, in m from the light barriers, as the plant has it. */
export const BELT = { begin: -0.3, end: 1.03 };
/** Of the box sizes 1 to 3, in units of the drawing: between the beams. */
export const HEIGHTS = [24, 46, 68];
export const LENGTH = 0.08;

const SCALE = 622;
const ZERO = { x: 247, y: 262 };
const DEPTH = { x: 26, y: -44 };

/** A point of the belt: m along it, and across it from its front edge (0) to its back edge (1). */
export function point(along: number, across: number): [number, number] {
  return [ZERO.x + along * SCALE + across * DEPTH.x, ZERO.y + across * DEPTH.y];
}

export interface Box {
  slot: number;
  size: number;
  front: number;
  pushed: number;
}

/** The boxes of the plant's six slots, the rightmost last, so that it covers none. */
export function boxesOf(values: Record<string, number>): Box[] {
  return [1, 2, 3, 4, 5, 6]
    .map((slot) => ({
      slot,
      size: values[`BOX${slot}`] ?? 0,
      front: values[`FRONT${slot}`] ?? 0,
      pushed: values[`PUSHED${slot}`] ?? 0,
    }))
    .filter((box) => box.size > 0)
    .sort((a, b) => b.front - a.front);
}

/** Where a box stands across the belt, and how far it has fallen: over the front edge when it is pushed on. */
export function offBelt(pushed: number): { across: number; down: number } {
  const part = Math.max(0, (pushed - 0.5) * 2);
  return { across: 0.15 - part * 1.1, down: part * part * 70 };
}
