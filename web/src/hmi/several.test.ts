import { expect, test } from 'vitest';
import { HEIGHT, WIDTH, type Item } from './picture';
import { aligned, appended, copies, enclosed, layered, moved, resized, toggled, without } from './several';

const lamp = (x: number, y: number, text = ''): Item => ({
  kind: 'lamp',
  x,
  y,
  width: 40,
  height: 40,
  operand: 'A 1.0',
  text,
  from: 0,
  to: 100,
  format: 'AUTO',
});
const items = [lamp(20, 20, 'a'), lamp(100, 60, 'b'), lamp(200, 300, 'c')];
const places = (some: readonly Item[]) => some.map(({ x, y }) => `${x},${y}`).join(' ');
const texts = (some: readonly Item[]) => some.map(({ text }) => text).join('');

test('several move together and keep their places to each other, also at the edge', () => {
  expect(places(moved(items, [0, 2], { x: 14, y: -10 }))).toBe('30,10 100,60 210,290');
  expect(places(moved(items, [0, 1], { x: -500, y: -500 }))).toBe('0,0 80,40 200,300');
  expect(places(moved(items, [1, 2], { x: 9999, y: 9999 }))).toBe(
    `20,20 ${WIDTH - 140},${HEIGHT - 280} ${WIDTH - 40},${HEIGHT - 40}`,
  );
});

test('they are aligned, resized, deleted', () => {
  expect(places(aligned(items, [1, 2], 'x'))).toBe('20,20 100,60 100,300');
  expect(places(aligned(items, [2, 0], 'y'))).toBe('20,20 100,60 200,20');
  expect(resized(items, [0, 1], { x: 10, y: 0 }).map(({ width }) => width)).toEqual([50, 50, 40]);
  expect(texts(without(items, [0, 2]))).toBe('b');
});

test('copies lie beside the originals, and what the file says about those stays there', () => {
  expect(copies([{ ...items[0]!, above: ['// Line 1'] }, items[1]!])).toEqual([lamp(40, 40, 'a'), lamp(120, 80, 'b')]);
  const after = appended(items, copies(items.slice(0, 2)))!;
  expect([texts(after.items), after.chosen]).toEqual(['abcab', [3, 4]]);
  expect(appended(Array(499).fill(items[0]), items)).toBe(null);
});

test('to the front and to the back in their order, and chosen still', () => {
  const front = layered(items, [1, 0], true);
  expect([texts(front.items), front.chosen]).toEqual(['cab', [1, 2]]);
  const back = layered(items, [1, 2], false);
  expect([texts(back.items), back.chosen]).toEqual(['bca', [0, 1]]);
});

test('a frame chooses what lies wholly in it, from whichever corner it is drawn', () => {
  expect(enclosed(items, { x: 145, y: 105 }, { x: 10, y: 10 })).toEqual([0, 1]);
  expect(enclosed(items, { x: 30, y: 10 }, { x: 145, y: 105 })).toEqual([1]);
  expect(toggled([0, 1], 1)).toEqual([0]);
  expect(toggled([0], 2)).toEqual([0, 2]);
});
