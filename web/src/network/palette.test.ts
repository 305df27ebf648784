import { expect, test } from 'vitest';
import type { NetworkElement } from '../connection/protocol';
import { bestOf, grouped } from './palette';

type Named = [id: string, group: NetworkElement['group'], german: string, english: string];
const rows: Named[] = [
  ['CALL_IF', 'coil', '(CALL)', '(CALL)'],
  ['CALL_BOX', 'call', 'CALL', 'CALL'],
  ['CONNECTOR', 'bit', '-(#)-', '-(#)-'],
  ['R', 'coil', '(R)', '(R)'],
  ['SE', 'coil', '(SV)', '(SE)'],
  ['SD', 'coil', '(SE)', '(SD)'],
  ['SF', 'coil', '(SA)', '(SF)'],
  ['SAVE', 'coil', '(SAVE)', '(SAVE)'],
  ['S_PULSE', 'box', 'S_IMPULS', 'S_PULSE'],
];
const plain = (name: string) => name.replace(/[()]/g, '');
const named = (english: boolean): NetworkElement[] =>
  rows.map(([id, group, ...names]) => {
    const [kop, other] = english ? [names[1], names[0]] : names;
    const element = { id, group, kop, fup: plain(kop) };
    return kop === other ? element : { ...element, other: { kop: other, fup: plain(other) } };
  });
const best = (filter: string, english = false) => bestOf(grouped(named(english), 'kop', filter), filter)?.id;

test('Enter takes the element of the typed name, otherwise the first one found', () => {
  expect(best('call')).toBe('CALL_BOX');
  expect(best('(call)')).toBe('CALL_IF');
  expect(best('cal')).toBe('CALL_IF');
  expect(best('r')).toBe('R');
  expect(best('imp')).toBe('S_PULSE');
  expect(best('contact')).toBeUndefined();
  expect(best('connector')).toBe('CONNECTOR');
});

test('the exact name in the mnemonics of the text is the only one', () => {
  expect(best('SE')).toBe('SD');
  expect(best('sv')).toBe('SE');
  expect(best('SE', true)).toBe('SE');
  const shown = grouped(named(false), 'kop', 'SE').flatMap(({ elements }) => elements);
  expect(shown.map(({ name }) => name)).toEqual(['(SE)']);
});

test('without one, names in the other mnemonics are found and shown', () => {
  expect(best('SD')).toBe('SD');
  expect(best('SA', true)).toBe('SF');
  expect(best('sv', true)).toBe('SE');
  expect(best('pulse')).toBe('S_PULSE');
  expect(grouped(named(false), 'kop', 'pulse')[0]?.elements).toEqual([
    { id: 'S_PULSE', name: 'S_IMPULS', key: undefined, other: 'S_PULSE' },
  ]);
  expect(grouped(named(false), 'fup', 'sf')[0]?.elements).toMatchObject([{ name: 'SA', other: 'SF' }]);
});
