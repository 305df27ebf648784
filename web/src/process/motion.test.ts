import { expect, test } from 'vitest';
import { between } from './motion';

const frame = (at: number, values: Record<string, number>) => ({ at, plants: { Belt: values } });

test('positions glide from one frame to the next, bits and counters jump', () => {
  const shown = between(frame(0, { FRONT1: 0.1, GOOD: 1 }), frame(40, { FRONT1: 0.2, GOOD: 2 }), 60);
  expect(shown.Belt!.FRONT1).toBeCloseTo(0.15);
  expect(shown.Belt!.GOOD).toBe(2);
});

test('a box that is put at the beginning does not fly back', () => {
  const shown = between(frame(0, { FRONT1: 0.9 }), frame(40, { FRONT1: -0.2 }), 41);
  expect(shown.Belt!.FRONT1).toBe(-0.2);
});

test('after the length of a frame there is nothing to wait for', () => {
  const latest = frame(2000, { LEVEL: 5 });
  expect(between(frame(0, { LEVEL: 9 }), latest, 2100)).toBe(latest.plants);
  expect(between(null, latest, 2000)).toBe(latest.plants);
});
