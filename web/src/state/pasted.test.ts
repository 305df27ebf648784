import { expect, test } from 'vitest';
import { cellsOf, isTable, pastedInto } from './pasted';

test('lines or columns are a table, a single text is none', () => {
  expect(['a\tb', 'a\nb', 'a\r\nb\r\n'].map(isTable)).toEqual([true, true, true]);
  expect(['a', 'a b', 'a\n', '\ta\t', ''].map(isTable)).toEqual([false, false, false, false, false]);
});

test('cells without what a spreadsheet leaves around them', () => {
  expect(cellsOf('a \t b\r\n\r\n c\t\n')).toEqual([
    ['a', 'b'],
    ['c', ''],
  ]);
});

test('rows come below the chosen one, or in its place', () => {
  expect(pastedInto(['a', 'b', 'c'], 1, false, ['x', 'y'])).toEqual(['a', 'b', 'x', 'y', 'c']);
  expect(pastedInto(['a', 'b', 'c'], 1, true, ['x', 'y'])).toEqual(['a', 'x', 'y', 'c']);
});
