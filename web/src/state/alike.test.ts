import { expect, test } from 'vitest';
import { alike, among, goodOnes, isNumber, isText, listOf, objectOf } from './alike';

const odd = [null, [], {}, 'x', '', 1, true, [null], { a: null }, Number.POSITIVE_INFINITY];
const taken = (good: (stored: unknown) => boolean) => odd.filter(good);

test('what is stored has the kind of what is wanted', () => {
  expect(taken(alike('auto'))).toEqual(['x', '']);
  expect(taken(alike(1))).toEqual([1]);
  expect(taken(alike(true))).toEqual([true]);
  expect(taken(alike({}))).toEqual([{}, { a: null }]);
  expect(taken(alike(['a']))).toEqual([[]]);
});

test('words, lists, objects and what has names are checked to their elements', () => {
  expect(taken(among('x', 'y'))).toEqual(['x']);
  expect(taken(listOf(isText))).toEqual([[]]);
  expect(goodOnes({ a: 1, b: null, c: '2' }, isNumber)).toEqual({ a: 1 });
  for (const stored of odd.slice(0, 3)) expect(goodOnes(stored, isNumber)).toEqual({});
  const row = objectOf({ operand: isText }, { modify: isText });
  expect(row({ operand: 'MW 2' })).toBe(true);
  expect(row({ operand: 'MW 2', modify: 5 })).toBe(false);
  expect(row({ modify: '5' })).toBe(false);
});
