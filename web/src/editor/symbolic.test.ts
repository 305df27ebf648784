import { expect, test } from 'vitest';
import { SymbolIndex } from './catalogue';
import { shownAs, type Display } from './symbolic';

const symbols = new SymbolIndex([{ name: 'Start', operand: 'E 0.0', type: 'BOOL', comment: '' }]);
const as = (kind: string, text: string, display: Display, mnemonics: 'german' | 'international') =>
  shownAs(kind, text, { display, mnemonics, symbols });

test('an address is shown in the words of the text (S7-EDIT-18)', () => {
  expect(as('symbol', '"Start"', 'absolute', 'german')).toBe('E 0.0');
  expect(as('symbol', '"Start"', 'absolute', 'international')).toBe('I 0.0');
  expect(as('symbol', '"Stop"', 'absolute', 'german')).toBeUndefined();
});

test('a symbol is found for an operand of both words; what is written so stays', () => {
  expect(as('operand', 'I 0.0', 'symbolic', 'international')).toBe('"Start"');
  expect(as('operand', 'E0.0', 'symbolic', 'german')).toBe('"Start"');
  expect(as('symbol', '"Start"', 'symbolic', 'german')).toBeUndefined();
});
