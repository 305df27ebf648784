import { expect, test } from 'vitest';
import { rowTarget } from './row_keys';

const none = { ctrlKey: false, altKey: false, shiftKey: false, metaKey: false };
const from = (key: string, row: number, more = {}) =>
  rowTarget({ ...none, key, ...more }, { row, field: 'modify' }, 10)?.row;

test('arrows go to the next row, Ctrl with Home and End to the first and the last', () => {
  expect([from('ArrowDown', 3), from('ArrowUp', 3)]).toEqual([4, 2]);
  expect([from('ArrowDown', 9), from('ArrowUp', 0)]).toEqual([9, 0]);
  expect([from('End', 3, { ctrlKey: true }), from('Home', 3, { ctrlKey: true })]).toEqual([9, 0]);
});

test('in the text of a field keys do what they always do', () => {
  expect([from('End', 3), from('Enter', 3), from('ArrowDown', 3, { altKey: true })]).toEqual([
    undefined,
    undefined,
    undefined,
  ]);
});
