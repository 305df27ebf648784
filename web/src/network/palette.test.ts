import { expect, test } from 'vitest';
import { bestOf, grouped } from './palette';

const elements = [
  { id: 'CALL_IF', kop: '(CALL)', fup: 'CALL', group: 'coil' as const },
  { id: 'CALL_BOX', kop: 'CALL', fup: 'CALL', group: 'call' as const },
  { id: 'CONNECTOR', kop: '-(#)-', fup: '#', group: 'bit' as const },
  { id: 'R', kop: '(R)', fup: 'R', group: 'coil' as const },
  { id: 'SE', kop: '(SV)', fup: 'SV', group: 'coil' as const },
  { id: 'SD', kop: '(SE)', fup: 'SE', group: 'coil' as const },
  { id: 'S_PULSE', kop: 'S_IMPULS', fup: 'S_IMPULS', group: 'box' as const },
];
const best = (filter: string) => bestOf(grouped(elements, 'kop', filter), filter)?.id;

test('Enter takes the element of the typed name, otherwise the first one found', () => {
  expect(best('call')).toBe('CALL_BOX');
  expect(best('(call)')).toBe('CALL_IF');
  expect(best('cal')).toBe('CALL_IF');
  expect(best('r')).toBe('R');
  expect(best('SE')).toBe('SD');
  expect(best('sv')).toBe('SE');
  expect(best('imp')).toBe('S_PULSE');
  expect(best('nothing')).toBeUndefined();
});
