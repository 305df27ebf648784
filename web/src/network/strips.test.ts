import { expect, test } from 'vitest';
import type { NetworkShape } from '../connection/protocol';
import { COLUMN, MARGIN, rectOf } from './geometry';
import { stripsOf, undivided, WIDEST } from './strips';

const rect = (x: number, width: number) => ({ x, y: 0, width, height: 20 });

test('what a page is wide enough for is one strip', () => {
  expect(stripsOf(WIDEST, [rect(10, 1000)])).toEqual([{ from: 0, to: WIDEST }]);
});

test('a wider network is cut beside its contacts and texts, and all of it is there', () => {
  const contacts = Array.from({ length: 13 }, (_, index) => rect(MARGIN + index * 24 * COLUMN, 23 * COLUMN));
  const strips = stripsOf(2929, contacts);
  expect(strips[0]!.from).toBe(0);
  expect(strips.at(-1)!.to).toBe(2929);
  strips.slice(1).forEach(({ from }, index) => expect(from).toBe(strips[index]!.to));
  for (const { from, to } of strips) {
    expect(to - from).toBeLessThanOrEqual(WIDEST);
    expect(contacts.filter(({ x, width }) => x < to && to < x + width)).toEqual([]);
  }
  expect(strips.length).toBe(3);
});

test('a cut is the last edge of a column where there is nothing, also between two that touch', () => {
  const edge = MARGIN + 119 * COLUMN;
  expect(edge).toBeLessThanOrEqual(WIDEST);
  expect(stripsOf(1500, [])[0]!.to).toBe(edge);
  expect(stripsOf(1500, [rect(edge - 4 * COLUMN, 3 * COLUMN), rect(edge - COLUMN, 2 * COLUMN)])[0]!.to).toBe(
    edge - COLUMN,
  );
});

test('what is wider than the paper itself is cut, not lost', () => {
  expect(stripsOf(2 * WIDEST + 5, [rect(0, 3000)]).map(({ to }) => to)).toEqual([WIDEST, 2 * WIDEST, 2 * WIDEST + 5]);
});

test('wires may be cut, a text may not, however long', () => {
  const shape = (kind: NetworkShape['kind'], w: number, text = ''): NetworkShape => ({
    kind,
    x: 2,
    y: 0,
    w,
    h: 0,
    text,
  });
  expect(undivided(shape('wire', 30))).toEqual([]);
  expect(undivided(shape('contact', 3))).toEqual([rectOf(shape('contact', 3))]);
  expect(undivided(shape('text', 0, 'Endlage'))[0]!.width).toBe(7 * COLUMN);
});
