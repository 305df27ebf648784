import { expect, test } from 'vitest';
import { decode, emptyRow, formatOf, fromText, meaningful, shownRows, toText, type SymbolRow } from './rows';

const row = (symbol: string, operand: string): SymbolRow => ({ symbol, operand, type: 'BOOL', comment: '' });
const rows = [row('Motor', 'A 10.0'), row('anlasser', 'A 2.0'), row('Ende', 'E 0.1')];

test('rows survive as text, without the empty ones at the end', () => {
  expect(fromText(toText([...rows, emptyRow(), emptyRow()]))).toEqual(rows);
  expect(meaningful([emptyRow(), rows[0]!, emptyRow()]).length).toBe(2);
});

test('sorting counts numbers as numbers and ignores case (S7-SYM-17)', () => {
  expect(shownRows(rows, '', { field: 'operand', down: false })).toEqual([1, 0, 2]);
  expect(shownRows(rows, '', { field: 'symbol', down: false })).toEqual([1, 2, 0]);
  expect(shownRows(rows, '', { field: 'symbol', down: true })).toEqual([0, 2, 1]);
});

test('the filter looks into all columns', () => {
  expect(shownRows(rows, 'a ', null)).toEqual([0, 1]);
  expect(shownRows(rows, 'ENDE', null)).toEqual([2]);
});

test('files of STEP 7 are read in their code page', () => {
  expect(decode(new Uint8Array([0x54, 0xfc, 0x72]).buffer)).toBe('Tür');
  expect(decode(new TextEncoder().encode('Tür').buffer as ArrayBuffer)).toBe('Tür');
  expect(formatOf('Symbole.SDF')).toBe('sdf');
  expect(formatOf('Symbole.xls')).toBeNull();
});
