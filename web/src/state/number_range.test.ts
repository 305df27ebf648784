import { expect, test } from 'vitest';
import { beyond, typeOf } from './number_range';

const check = (type: string, value: string) => beyond({ operand: 'MW 10', type, value });

test('a number that is too large or too small is told with the range and the operand', () => {
  expect(check('INT', ' 99999 ')).toEqual([
    { operand: 'MW 10', value: '99999', type: 'INT', low: -32768, high: 32767 },
  ]);
  expect(check('INT', '-32769')).toHaveLength(1);
  expect(check('DINT', '2147483648')).toHaveLength(1);
});

test('what fits, and what is no whole number, is left to the CPU', () => {
  for (const value of ['32767', '-32768', '+5', '', 'W#16#1', '1.5']) expect(check('INT', value)).toEqual([]);
  expect(check('REAL', '99999')).toEqual([]);
});

test('DEC is INT in a word and DINT in a double word', () => {
  expect(typeOf('MW 10', 'DEC')).toBe('INT');
  expect(typeOf('db1.dbd4', 'DEC')).toBe('DINT');
  for (const [operand, format] of [
    ['MW 10', 'HEX'],
    ['MB 0', 'DEC'],
    ['E 0.0', 'DEC'],
    ['T 1', 'DEC'],
    ['"Speed"', 'DEC'],
  ])
    expect(typeOf(operand!, format!)).toBe('');
});
