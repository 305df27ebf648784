import { expect, test } from 'vitest';
import { padded, pointsOf, rangeOf, setpoints, since } from './profile';

test('the rows since an instant', () => {
  expect(since([1, 2, 3, 4], 2.5)).toBe(2);
  expect(since([1, 2, 3, 4], 2)).toBe(1);
  expect(since([1, 2], 9)).toBe(2);
  expect(since([], 0)).toBe(0);
});

test('a level is its two ends, gaps are left out', () => {
  const x = [0, 1, 2, 3, 4, 5];
  expect(pointsOf(x, [7, 7, 7, 7, 9, null], 0)).toEqual([
    [0, 7],
    [3, 7],
    [4, 9],
  ]);
  expect(pointsOf(x, [7, 7, 7, 7, 9, null], 4)).toEqual([[4, 9]]);
});

test('a range is never empty', () => {
  expect(rangeOf([], { low: 0, high: 1 })).toEqual({ low: 0, high: 1 });
  expect(rangeOf([0], { low: 0, high: 1 })).toEqual({ low: -1, high: 1 });
  expect(rangeOf([5, -2, 3], { low: 0, high: 1 })).toEqual({ low: -2, high: 5 });
  expect(padded({ low: 0, high: 100 }, 0.1)).toEqual({ low: -10, high: 110 });
});

test('volts are a speed; with a direction signal its sign', () => {
  expect(setpoints([10, -5, null], [1, 1, 1], { speed: 10_000 })).toEqual([10_000, -5000, null]);
  expect(setpoints([10, 5], [0, 1], { speed: 8000, direction_signal: 1 })).toEqual([8000, -4000]);
});
