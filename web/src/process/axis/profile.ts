// From samples to lines of a chart.
export type Point = readonly [x: number, y: number];

export interface Line {
  name: string;
  /** Of the tokens --curve-1 to --curve-6. */
  token: string;
  dash?: string;
  points: Point[];
}

export interface Range {
  low: number;
  high: number;
}

/** Rows from an instant on: time stands in the first column and only rises. */
export function since(time: number[], from: number): number {
  let low = 0,
    high = time.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time[middle]! < from) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** A point for each row from the first on that has both; a row that says nothing new is left out. */
export function pointsOf(x: (number | null)[], y: (number | null)[], first: number): Point[] {
  const points: Point[] = [];
  for (let row = first; row < Math.min(x.length, y.length); ++row) {
    const at = x[row],
      value = y[row];
    if (at == null || value == null) continue;
    const last = points.at(-1),
      before = points.at(-2);
    if (last && before && last[1] === value && before[1] === value && row > first) points.pop();
    points.push([at, value]);
  }
  return points;
}

export function rangeOf(values: number[], otherwise: Range): Range {
  let low = Infinity,
    high = -Infinity;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return otherwise;
  if (low < high) return { low, high };
  const around = Math.abs(low) * 0.1 || 1;
  return { low: low - around, high: high + around };
}

/** With room at both ends. */
export const padded = ({ low, high }: Range, share = 0.06): Range => {
  const room = (high - low) * share;
  return { low: low - room, high: high + room };
};

/** The set-point at the analog output as a speed: 10 V are the highest one. */
export function setpoints(
  volts: (number | null)[],
  direction: (number | null)[],
  { speed = 0, direction_signal: signed = 0 }: Record<string, number>,
): (number | null)[] {
  return volts.map((value, row) =>
    value === null ? null : (value / 10) * speed * (signed && direction[row] ? -1 : 1),
  );
}
