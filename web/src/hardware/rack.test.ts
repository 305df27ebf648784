import { expect, test } from 'vitest';
import { addresses, housings, lamps, title, type Slot } from './rack';

const slot = (place: string, operands: string[], more: Partial<Slot> = {}): Slot => ({
  slot: place,
  order: '',
  name: '',
  type: '',
  present: true,
  kind: '',
  terminals: operands.map((operand) => ({ text: '', operand, symbol: '' })),
  properties: [],
  faults: [],
  ...more,
});

test('the submodules of a compact CPU sit in its housing', () => {
  const list = housings({ rack: 0, slots: ['1', '2', '2.2', '2.3', '4'].map((place) => slot(place, [])) });
  expect(list.map((one) => [one.main.slot, one.parts.length])).toEqual([
    ['1', 0],
    ['2', 2],
    ['4', 0],
  ]);
});

test('addresses come from the terminals, or from the ranges where there are none', () => {
  expect(addresses(slot('2.2', ['E 124.0', 'E 124.1', 'E 126.7', 'A 124.0']))).toEqual(['E 124.0…126.7', 'A 124.0']);
  expect(addresses(slot('AS4/3', ['PEB 257', 'PEB 257', 'PAB 257']))).toEqual(['PEB 257', 'PAB 257']);
  expect(addresses(slot('2.4', [], { inputs: { first: 768, bytes: 16 } }))).toEqual(['PE 768…783']);
});

test('only digital terminals have a lamp', () => {
  expect(lamps(slot('4', ['E 0.0', 'PEW 752'])).length).toBe(1);
});

test('a bus is no rack', () => {
  expect(title({ rack: 1, slots: [] })).toEqual({ key: 'rack', values: { number: 1 } });
  expect(title({ rack: 504, slots: [], bus: 'asi', place: '4' })).toEqual({ key: 'asi', values: { number: '4' } });
});
