import { expect, test } from 'vitest';
import type { NetworkShape } from '../connection/protocol';
import { blamedAt, nextPin, outside, withinBox } from './boxes';
import { itemsOf } from './items';

const at = (kind: NetworkShape['kind'], x: number, y: number, more: Partial<NetworkShape> = {}): NetworkShape => ({
  kind,
  x,
  y,
  w: 4,
  h: 0,
  ...more,
});
const pin = (kind: 'text' | 'field', x: number, y: number, number: number, text?: string) =>
  at(kind, x, y, { node: 3, pin: number, line: 1, ...(text ? { text } : {}) });
const name = (x: number, y: number, text: string) => at('text', x, y, { text, w: text.length });

// A call: EN and the parameter done open, level missing.
const items = itemsOf([
  at('frame', 10, 1, { node: 3, w: 14, h: 7, line: 5 }),
  at('text', 14, 2, { text: 'FB 1', node: 3, pin: 0, line: 1 }),
  at('text', 14, 0, { text: 'DB 1', node: 3, pin: 0, line: 1 }),
  name(11, 3, 'EN'),
  pin('field', 11, 3, -2),
  name(11, 4, 'start'),
  pin('text', 4, 4, 1, 'E 0.0'),
  name(11, 5, 'level'),
  pin('text', 5, 5, 2, '???'),
  name(19, 3, 'ENO'),
  name(19, 4, 'done'),
  pin('field', 19, 4, 4),
]);
const of = (number: number) => items.find((item) => item.pin === number)!;
const step = (from: number, direction: 'up' | 'down' | 'left' | 'right') =>
  withinBox(items, { ...of(from) }, direction)?.pin;

test('the arrows go through the inputs, open ones too, then to the outputs', () => {
  expect([step(-1, 'down'), step(-2, 'down'), step(1, 'down'), step(2, 'down'), step(4, 'down')]).toEqual([
    -2,
    1,
    2,
    4,
    undefined,
  ]);
  expect([step(4, 'up'), step(1, 'up'), step(-2, 'up')]).toEqual([2, -2, -1]);
});

test('across, at the same height, and out of the box', () => {
  expect([step(1, 'right'), step(4, 'left'), step(4, 'right'), step(1, 'left')]).toEqual([4, 1, undefined, undefined]);
});

test('up from a box leads out of it, not to its pins', () => {
  const frame = items.find(({ kind }) => kind === 'frame')!;
  expect(outside(items, frame, 'up')).toEqual([]);
  expect(outside(items, frame, 'left')).toHaveLength(items.length);
});

test('Enter goes to the next open pin of a call, never to EN', () => {
  expect(nextPin(items, { node: 3, field: -1 })?.pin).toBe(2);
  expect(nextPin(items, { node: 3, field: 2 })?.pin).toBe(4);
  expect(nextPin(items, { node: 3, field: 4 })).toBeUndefined();
});

test('only what is missing is framed, EN is not', () => {
  expect([...blamedAt(items, ({ line }) => line === 1)].map((item) => item.pin)).toEqual([2]);
});
