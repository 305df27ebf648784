import { expect, test } from 'vitest';
import type { Item } from './items';
import { meant, offersAt } from './offers';

const all = [
  { label: '#start', detail: 'IN  BOOL', type: 'local' },
  { label: '#speed', detail: 'IN  INT', type: 'local' },
  { label: '"Start"', detail: 'E 0.0  BOOL', type: 'symbol' },
  { label: '"Level"', detail: 'MW 2  WORD', type: 'symbol' },
  { label: '"Delay"', detail: 'T 1  TIMER', type: 'symbol' },
  { label: '"Parts"', detail: 'Z 1  COUNTER', type: 'symbol' },
  { label: '"Classify"', detail: 'FB 1  FB 1', type: 'symbol' },
  { label: 'DB 1', detail: '', type: 'block' },
];
const item = (kind: Item['kind'], name: string): Item => ({
  node: 1,
  pin: -1,
  first: -1,
  kind,
  name,
  rect: { x: 0, y: 0, width: 1, height: 1 },
  place: { x: 0, y: 0, width: 1, height: 1 },
  line: 0,
  operand: '',
  field: 0,
  value: undefined,
  bcd: false,
  type: undefined,
  parameter: undefined,
});
const labels = (kind: Item['kind'], name: string) => offersAt(item(kind, name), 'kop', all).map(({ label }) => label);

test('a contact is offered bits, timers and counters, no block', () => {
  expect(labels('contact', '/')).toEqual(['#start', '"Start"', '"Delay"', '"Parts"']);
});
test('boxes of timers and counters are offered these', () => {
  expect(labels('frame', 'S_EVERZ')).toEqual(['"Delay"']);
  expect(labels('coil', 'SE')).toEqual(['"Delay"']);
  expect(labels('frame', 'S_CUD')).toEqual(['"Parts"']);
  expect(labels('frame', 'ZAEHLER')).toEqual(['"Parts"']);
});
test('a call is offered blocks, a pin anything else', () => {
  expect(labels('coil', 'CALL')).toEqual(['"Classify"', 'DB 1']);
  expect(labels('text', '')).toEqual(['#start', '#speed', '"Start"', '"Level"', '"Delay"', '"Parts"']);
});

test.each([
  ['start', '#start'],
  ['"Lev', '"Level"'],
  ['#spe', '#speed'],
  ['T 1', undefined],
  ['s', undefined],
  ['', undefined],
])('%s is completed to %s', (typed, wanted) => {
  const offered = all.filter(
    ({ label }) => typed.length < 3 || label.toLowerCase().includes(typed.replace(/["#]/g, '').toLowerCase()),
  );
  expect(meant(typed, offered)).toBe(wanted);
});
