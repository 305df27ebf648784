import { expect, test } from 'vitest';
import type { NetworkShape } from '../connection/protocol';
import { itemsOf } from './items';
import { elementsWith, standingAt } from './statement_at';

const at = (kind: NetworkShape['kind'], x: number, y: number, more: Partial<NetworkShape>): NetworkShape => ({
  kind,
  x,
  y,
  w: 4,
  h: 0,
  ...more,
});

// U E 0.0; SPBNB end; L MW 20; BTI; T MW 30; end: NOP 0;  then = A 4.0: lines 1, 2, 3 to 6, 7.
const items = itemsOf([
  at('contact', 1, 2, { node: 0, line: 1 }),
  at('text', 1, 1, { node: 0, pin: 0, line: 1, text: 'E 0.0' }),
  at('frame', 10, 1, { node: 5, w: 14, h: 5, line: 6 }),
  at('text', 14, 2, { text: 'BCD_I' }),
  at('text', 11, 3, { text: 'EN' }),
  at('field', 11, 3, { node: 5, pin: -2, line: 4 }),
  at('text', 11, 4, { text: 'IN', w: 2 }),
  at('text', 5, 4, { node: 5, pin: 1, line: 3, text: 'MW 20' }),
  at('text', 20, 4, { text: 'OUT', w: 3 }),
  at('text', 25, 4, { node: 5, pin: 2, line: 5, text: 'MW 30' }),
  at('coil', 40, 3, { node: 6, line: 7 }),
]);
const standing = (line: number) => standingAt(items, line).map(({ kind, operand }) => operand ?? kind);
const element = (line: number) => [...elementsWith(items, line)].map(({ kind }) => kind);

test('a statement with an operand stands at it, another one at what it leads to, never at an open pin', () => {
  expect([1, 2, 3, 4, 7, 8].map(standing)).toEqual([['E 0.0'], ['MW 20'], ['MW 20'], ['MW 30'], ['coil'], []]);
});

test('what a box does is the box, whichever of its statements it is', () => {
  expect([1, 2, 3, 4, 5, 6, 7].map(element)).toEqual([
    ['contact'],
    ...Array.from({ length: 5 }, () => ['frame']),
    ['coil'],
  ]);
});
