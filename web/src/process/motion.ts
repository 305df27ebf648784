/** Values of one plant by their names. */
export type Values = Record<string, number>;

/** What the server showed at an instant of the browser's clock, in ms. */
export interface Frame {
  at: number;
  plants: Record<string, Values>;
}

/** Frames come every 33 ms; what stays away longer is not waited for. */
const LONGEST_MS = 100;

/** A box that is put where another one was, and a counter, do not glide: only small steps of positions do. */
const GLIDES = /^(FRONT\d|PUSHED\d|STROKE_\w+|LEVEL|POSITION|HEIGHT|DOORWAY|PV)$/;
const largestStep = (name: string, value: number) =>
  Math.max(0.2, /^(FRONT|PUSHED|STROKE|HEIGHT)/.test(name) ? 0 : Math.abs(value) * 0.2 + 5);

/** The picture one frame behind, so that there is always a next one to go to. */
export function between(before: Frame | null, latest: Frame, now: number): Record<string, Values> {
  if (!before) return latest.plants;
  const length = Math.min(latest.at - before.at, LONGEST_MS);
  const part = length > 0 ? (now - latest.at) / length : 1;
  if (part >= 1) return latest.plants;
  const plants: Record<string, Values> = {};
  for (const [name, values] of Object.entries(latest.plants))
    plants[name] = glide(before.plants[name] ?? values, values, Math.max(0, part));
  return plants;
}

function glide(from: Values, to: Values, part: number): Values {
  const values: Values = {};
  for (const [name, value] of Object.entries(to)) {
    const start = from[name] ?? value;
    const glides = GLIDES.test(name) && Math.abs(value - start) <= largestStep(name, value);
    values[name] = glides ? start + (value - start) * part : value;
  }
  return values;
}
