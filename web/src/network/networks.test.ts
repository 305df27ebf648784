import { expect, test } from 'vitest';
import type { NetworkElement, NetworkPicture } from '../connection/protocol';
import { changeOf, isTyped, placed } from './keys';
import { merged } from './networks.svelte';
import { grouped } from './palette';

const picture = (number: number, line: number, title = ''): NetworkPicture => ({
  number,
  title,
  comment: '',
  label: '',
  line,
  end: line + 3,
  first: line + 2,
  view: 'kop',
  w: 1,
  h: 1,
  shapes: [{ kind: 'wire', x: 0, y: 0, w: 1, h: 0 }],
  sentences: [],
});

test('only what has changed is drawn again', () => {
  const old = [picture(1, 5), picture(2, 9), picture(3, 13)];
  const fresh = merged(old, [picture(1, 5), picture(2, 9, 'other'), picture(3, 14)]);
  expect(fresh[0]).toBe(old[0]);
  expect(fresh[1]?.title).toBe('other');
  expect(fresh[2]).not.toBe(old[2]);
  expect(fresh[2]?.shapes).toBe(old[2]?.shapes);
  expect(fresh[2]?.line).toBe(14);
});

const key = (name: string, more = {}) => ({ key: name, ctrl: false, alt: false, shift: false, ...more });

test("the keys are STEP 7's, in KOP and in FUP", () => {
  expect(changeOf(key('F2'), 'kop')).toMatchObject({ action: 'insert', element: 'CONTACT' });
  expect(changeOf(key('F2'), 'fup')).toMatchObject({ element: 'AND' });
  expect(changeOf(key('F8'), 'kop')).toMatchObject({ place: 'parallel' });
  expect(changeOf(key('F9'), 'fup')).toMatchObject({ action: 'negate' });
  expect(changeOf(key('F9', { alt: true }), 'kop')).toBeUndefined();
  expect(changeOf(key('Delete'), 'kop')).toMatchObject({ action: 'delete' });
});

test('letters begin an operand, with Ctrl they do not', () => {
  expect(isTyped(key('e'))).toBe(true);
  expect(isTyped(key('"'))).toBe(true);
  expect(isTyped(key('s', { ctrl: true }))).toBe(false);
  expect(isTyped(key('ArrowUp'))).toBe(false);
});

test('an element goes to the open pin that is selected', () => {
  const pin = { kind: 'field', node: 1, pin: 2, first: -1 } as Parameters<typeof placed>[1];
  expect(placed(changeOf(key('F2'), 'kop')!, pin).place).toBe('atPin');
  expect(placed(changeOf(key('F2'), 'kop')!, null).place).toBe('behind');
  expect(placed(changeOf(key('F8'), 'kop')!, pin).place).toBe('parallel');
});

test('the palette has what the view has, in its groups', () => {
  const elements: NetworkElement[] = [
    { id: 'COIL', kop: '( )', fup: '=', group: 'coil', key: 'F7' },
    { id: 'CONTACT', kop: '-| |-', fup: '', group: 'bit' },
    { id: 'ADD_I', kop: 'ADD_I', fup: 'ADD_I', group: 'move' },
  ];
  expect(grouped(elements, 'kop', '').map(({ id }) => id)).toEqual(['bit', 'coil', 'move']);
  expect(grouped(elements, 'fup', '').map(({ id }) => id)).toEqual(['coil', 'move']);
  expect(grouped(elements, 'kop', 'add')[0]?.elements).toEqual([{ id: 'ADD_I', name: 'ADD_I', key: undefined }]);
});
