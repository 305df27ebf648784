// Target and switching points of a run, in pulses of the CPU and of the plant.
import type { Axis } from '../../connection/protocol';

type Values = Record<string, number>;

export interface Points {
  direction: 1 | -1;
  target: number;
  changeover: number | null;
  cutOff: number | null;
  /** Half the target range. */
  half: number;
}

/** Undefined: there is no run to a target, and there was none. */
export function pointsOfRun(
  axis: Axis,
  shown: Values,
  direction: 1 | -1,
  differences: (number | undefined)[],
): Points | undefined {
  const TARGETED = [4, 5];
  if (!TARGETED.includes(shown.mode ?? 0)) return undefined;
  const target = shown.target ?? 0;
  const [changePlus, cutPlus, changeMinus, cutMinus] = differences;
  const before = (difference: number | undefined) =>
    difference === undefined ? null : target - direction * difference;
  return {
    direction,
    target,
    changeover: before(direction > 0 ? changePlus : changeMinus),
    cutOff: before(direction > 0 ? cutPlus : cutMinus),
    half: axis.targetRange / 2,
  };
}

/** Where a position of the CPU is in the plant: a run of the plant counts up or down there. */
export function inPlant(axis: Axis, plantPulses: number, shown: Values): (position: number) => number {
  const sign = axis.inverted ? -1 : 1;
  return (position) => plantPulses + sign * (position - (shown.position ?? 0));
}
