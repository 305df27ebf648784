import { expect, test } from 'vitest';
import { scale, stepOf, timeText } from './picture';

test('steps of the axis are 1, 2, 5 times a power of ten', () => {
  expect(stepOf(0.9)).toBe(1);
  expect(stepOf(1)).toBe(1);
  expect(stepOf(1.1)).toBe(2);
  expect(stepOf(0.003)).toBeCloseTo(0.005, 9);
  expect(stepOf(60)).toBe(100);
});

test('times have the digits that the step needs', () => {
  expect(timeText(61.5, 0.5)).toBe('0:01:01.5');
  expect(timeText(1.0002, 0.0002)).toBe('0:00:01.0002');
});

test('pixels and seconds', () => {
  const to = scale(176, { from: 1, to: 3 });
  expect(to.x(1)).toBe(76);
  expect(to.x(3)).toBe(176);
  expect(to.time(126)).toBe(2);
});
