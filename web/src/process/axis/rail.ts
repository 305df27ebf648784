// Where things of an axis stand in its picture: pulses along the rail, or around the table.

type Parameters = Record<string, number>;

/** Of the picture: from the left to the right end of the rail. */
export const LEFT = 150;
export const RIGHT = 810;
/** Beside the limit switches. */
const MARGIN = 0.06;

export interface Rail {
  low: number;
  high: number;
}

/** A little more than the way between the hardware limit switches. */
export function railOf({ low_switch: low = 0, high_switch: high = 1 }: Parameters): Rail {
  const [from, to] = low < high ? [low, high] : [low - 1, low + 1];
  const margin = (to - from) * MARGIN;
  return { low: from - margin, high: to + margin };
}

/** What is beyond the picture stands at its edge. */
export function xOf({ low, high }: Rail, pulses: number): number {
  const share = (pulses - low) / (high - low);
  return LEFT + Math.min(1, Math.max(0, share)) * (RIGHT - LEFT);
}

/** Round numbers between two others, at most so many. */
export function ticks(low: number, high: number, most = 7): number[] {
  const rough = (high - low) / most;
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= rough) ?? 10 * power;
  const list: number[] = [];
  for (let at = Math.ceil(low / step) * step; at <= high; at += step) list.push(Math.round(at / step) * step + 0);
  return list;
}

/** 0 to 1 of a turn of a rotary axis. */
export function turn(revolution: number, pulses: number): number {
  const rest = pulses % revolution;
  return (rest < 0 ? rest + revolution : rest) / revolution;
}

export const pulsesPerEncoderTurn = ({ increments = 1 }: Parameters) => 4 * increments;
