import { expect, test } from 'vitest';
import type { Axis } from '../../connection/protocol';
import { inPlant, pointsOfRun } from './points';

const axis: Axis = {
  output: 'analog',
  directionSignal: false,
  controlType: 1,
  rotary: false,
  inverted: false,
  rotaryEnd: 100_000,
  lowLimit: -100,
  highLimit: 100,
  targetRange: 50,
  highestSpeed: 10_000,
  creepSpeed: 1000,
  wires: [],
  blocks: [],
};

test('switching points lie before the target, with the differences of their direction', () => {
  const shown = { mode: 4, target: 20_000, position: 5 };
  expect(pointsOfRun(axis, shown, 1, [1000, 100, 2000, 200])).toEqual({
    direction: 1,
    target: 20_000,
    changeover: 19_000,
    cutOff: 19_900,
    half: 25,
  });
  expect(pointsOfRun(axis, shown, -1, [1000, 100, 2000, 200])).toMatchObject({ changeover: 22_000, cutOff: 20_200 });
  expect(pointsOfRun(axis, shown, 1, [])).toMatchObject({ target: 20_000, changeover: null, cutOff: null });
  expect(pointsOfRun(axis, { ...shown, mode: 1 }, 1, [])).toBeUndefined();
});

test('a position of the CPU in pulses of the plant', () => {
  expect(inPlant(axis, 12_000, { position: 2000 })(3000)).toBe(13_000);
  expect(inPlant({ ...axis, inverted: true }, 12_000, { position: 2000 })(3000)).toBe(11_000);
});
