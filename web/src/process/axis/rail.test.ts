import { expect, test } from 'vitest';
import { LEFT, RIGHT, railOf, ticks, turn, xOf } from './rail';

const rail = railOf({ low_switch: -20_000, high_switch: 320_000 });

test('both limit switches are within the picture', () => {
  expect(xOf(rail, -20_000)).toBeGreaterThan(LEFT);
  expect(xOf(rail, 320_000)).toBeLessThan(RIGHT);
  expect(xOf(rail, 150_000)).toBe((LEFT + RIGHT) / 2);
});

test('what is far away stands at the edge', () => {
  expect(xOf(rail, 1e9)).toBe(RIGHT);
  expect(xOf(rail, -1e9)).toBe(LEFT);
});

test('a rail without length does not divide by nothing', () => {
  const none = railOf({ low_switch: 5, high_switch: 5 });
  expect(xOf(none, 5)).toBe((LEFT + RIGHT) / 2);
});

test('ticks are round', () => {
  expect(ticks(-40_400, 340_400)).toEqual([0, 100_000, 200_000, 300_000]);
  expect(ticks(-3, 3, 6)).toEqual([-3, -2, -1, 0, 1, 2, 3]);
  expect(ticks(1, 1)).toEqual([]);
});

test('a rotary axis shows its position within the turn', () => {
  expect(turn(100_000, 25_000)).toBe(0.25);
  expect(turn(100_000, -25_000)).toBe(0.75);
  expect(turn(100_000, 325_000)).toBe(0.25);
});
