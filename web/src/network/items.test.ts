import { describe, expect, test } from 'vitest';
import type { NetworkShape } from '../connection/protocol';
import { inOrder, itemsOf, missing, next, nextMissing, same } from './items';

const shape = (kind: NetworkShape['kind'], x: number, y: number, more: Partial<NetworkShape> = {}): NetworkShape => ({
  kind,
  x,
  y,
  w: 3,
  h: 0,
  ...more,
});

// E 0.0 and E 0.1 in series, A 1.0 below them, the coil A 3.0.
const contact = (x: number, y: number, node: number, operand: string) => [
  shape('text', x, y, { text: operand, w: 5, node, pin: 0, line: node }),
  shape('contact', x + 1, y + 1, { node, line: node }),
];
const picture = [
  ...contact(3, 0, 0, 'E 0.0'),
  ...contact(12, 0, 1, 'E 0.1'),
  ...contact(3, 2, 2, '??.?'),
  shape('text', 24, 0, { text: '??.?', w: 5, node: 3, pin: 0, line: 3 }),
  shape('coil', 25, 1, { node: 3, line: 3 }),
  shape('wire', 6, 1),
];
const items = itemsOf(picture);
const at = (node: number) => items.find((item) => item.node === node)!;

describe('what can be selected', () => {
  test('a contact takes the operand above it', () => {
    expect(items.map(({ node, operand, field }) => [node, operand, field])).toEqual([
      [0, 'E 0.0', 0],
      [1, 'E 0.1', 0],
      [2, '??.?', 0],
      [3, '??.?', 0],
    ]);
  });

  test('a call is one operand, with its instance above the box', () => {
    const part = { node: 4, pin: 0, line: 4, written: 'FB 1, DB 1' };
    const call = itemsOf([
      shape('text', 4, 2, { text: 'FB 1', w: 4, ...part }),
      shape('text', 4, 0, { text: 'DB 1', w: 4, ...part }),
      shape('frame', 2, 1, { w: 8, h: 4, node: 4, line: 4 }),
    ]);
    expect(call.map(({ name, operand, field }) => [name, operand, field])).toEqual([['FB 1', 'FB 1, DB 1', 0]]);
    expect(call[0]!.place.y).toBeLessThan(call[0]!.rect.y + call[0]!.rect.height / 2);
  });

  test('a box has its pins beside it, and open ones', () => {
    const box = itemsOf([
      shape('frame', 5, 0, { node: 4, w: 9, h: 4 }),
      shape('text', 6, 1, { text: 'ADD_I', w: 5, node: 4 }),
      shape('text', 0, 2, { text: 'MW 2', w: 4, node: 4, pin: 1, line: 1 }),
      shape('field', 0, 3, { node: 4, pin: -2 }),
    ]);
    expect(box.map(({ pin, kind, name }) => [pin, kind, name])).toEqual([
      [-1, 'frame', 'ADD_I'],
      [1, 'text', 'MW 2'],
      [-2, 'field', ''],
    ]);
  });

  test('a gate and its last input are two, though their last statement is the same', () => {
    const gate = itemsOf([
      shape('frame', 8, 0, { node: 1, first: 0, w: 5, h: 3 }),
      shape('text', 0, 1, { text: 'E 0.1', w: 5, node: 1, pin: 0 }),
    ]);
    expect(gate).toHaveLength(2);
    expect(same(gate[0]!, gate[1]!)).toBe(false);
  });

  test('another form of the operand is shown, the written one is typed', () => {
    const [item] = itemsOf([shape('text', 0, 0, { text: '"Start"', written: 'E 0.0', node: 0, pin: 1 })]);
    expect(item?.operand).toBe('E 0.0');
  });
});

describe('the arrow keys', () => {
  test('go along the wire', () => {
    expect(next(items, at(0), 'right')?.node).toBe(1);
    expect(next(items, at(1), 'right')?.node).toBe(3);
    expect(next(items, at(1), 'left')?.node).toBe(0);
    expect(next(items, at(2), 'right')?.node).not.toBe(2);
  });
  test('go to the branch below and back', () => {
    expect(next(items, at(0), 'down')?.node).toBe(2);
    expect(next(items, at(2), 'up')?.node).toBe(0);
  });
  test('end at the edge', () => {
    expect(next(items, at(0), 'left')).toBeUndefined();
    expect(next(items, at(3), 'right')).toBeUndefined();
    expect(inOrder(items)[0]?.node).toBe(0);
  });
});

test('Enter goes to the next operand that is missing, and round', () => {
  expect(nextMissing(items, { node: 0, field: -1 })?.node).toBe(2);
  expect(nextMissing(items, { node: 2, field: 0 })?.node).toBe(3);
  expect(nextMissing(items, { node: 3, field: 0 })?.node).toBe(2);
  expect(missing('E 0.0')).toBe(false);
});
