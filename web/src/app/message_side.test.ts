import { expect, test } from 'vitest';
import { sideFor } from './message_side';

const box = (left: number, top: number, right: number, bottom: number) => ({ left, top, right, bottom });
const column = box(832, 700, 1272, 760);

test('messages are on the right, except over the control that was used', () => {
  expect(sideFor(box(900, 300, 1000, 330), column, 1280)).toBe('right');
  expect(sideFor(box(900, 710, 1000, 740), column, 1280)).toBe('left');
  expect(sideFor(box(100, 710, 200, 740), column, 1280)).toBe('right');
});

test('whatever side they are on now, and for what reaches below both', () => {
  expect(sideFor(box(900, 710, 1000, 740), box(8, 700, 448, 760), 1280)).toBe('left');
  expect(sideFor(box(0, 0, 1280, 800), column, 1280)).toBe('right');
});
