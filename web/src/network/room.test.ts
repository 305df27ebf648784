import { expect, test } from 'vitest';
import type { NetworkShape } from '../connection/protocol';
import { rectOf } from './geometry';
import { ASIDE, roomFor } from './room';

const word = (x: number, y: number, text: string): NetworkShape => ({ kind: 'text', x, y, w: text.length, h: 0, text });
const overlap = (a: DOMRectLike, b: DOMRectLike) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
type DOMRectLike = { x: number; y: number; width: number; height: number };

test('values of two pins cover neither their operands nor each other', () => {
  const operands = [word(12, 2, 'MW 10'), word(12, 3, 'MW 12')];
  const frame: NetworkShape = { kind: 'frame', x: 18, y: 1, w: 9, h: 4 };
  const values = roomFor(
    [...operands, frame],
    [
      { text: '12345', beside: rectOf(operands[0]!) },
      { text: '-7', beside: rectOf(operands[1]!) },
    ],
  );
  const all = [...operands.map(rectOf), ...values];
  for (const one of all) for (const other of all) if (one !== other) expect(overlap(one, other)).toBe(false);
  for (const one of values) expect(overlap(one, rectOf(frame))).toBe(false);
});

test('at the left edge a value goes below', () => {
  const operand = word(0, 0, 'MW 10');
  const wire: NetworkShape = { kind: 'wire', x: 5, y: 0, w: 4, h: 0 };
  const [value] = roomFor([operand, wire], [{ text: '5', beside: rectOf(operand) }]);
  expect(value!.y).toBeGreaterThanOrEqual(rectOf(operand).y + 20);
});

test.each(['inputOf', 'outputOf'] as const)('the value of an %s stands in the row of its pin', (side) => {
  const operands = [word(2, 2, 'MW 10'), word(2, 3, 'MW 12')];
  const rail: NetworkShape = { kind: 'rail', x: 0, y: 1, w: 0, h: 4 };
  const values = roomFor(
    [...operands, rail],
    operands.map((one) => ({ text: 'W#16#0000', beside: rectOf(one), side })),
  );
  values.forEach((value, index) => {
    const row = rectOf(operands[index]!);
    expect(value.y - row.y).toBeGreaterThanOrEqual(0);
    expect(value.y + value.height).toBeLessThanOrEqual(row.y + row.height);
    expect(overlap(value, row)).toBe(false);
    expect(value.x).toBeGreaterThanOrEqual(-ASIDE);
    if (side === 'inputOf') expect(value.x + value.width).toBeLessThan(8);
  });
});
