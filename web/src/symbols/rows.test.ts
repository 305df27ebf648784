import { expect, test } from 'vitest';

test('the data type comes from the operand', () => {
  const types: Record<string, string> = {
    'A 1.1': 'BOOL',
    'm20.0': 'BOOL',
    'EB 3': 'BYTE',
    'mw 10': 'WORD',
    'PEW 256': 'WORD',
    'MD 4': 'DWORD',
  };
  Object.assign(types, {
    'T 2': 'TIMER',
    'Z 1': 'COUNTER',
    'C 1': 'COUNTER',
    fc5: 'FC 5',
    'DB 100': 'DB 100',
    'UDT 1': 'UDT 1',
  });
  for (const [operand, type] of Object.entries(types)) expect(typeOfOperand(operand), operand).toBe(type);
  for (const none of ['', 'x', 'DB1.DBW 0', 'M 1', 'M 1.8']) expect(typeOfOperand(none), none).toBe('');
});
import {
  decode,
  emptyRow,
  formatOf,
  fromText,
  meaningful,
  pastedRows,
  shownRows,
  toText,
  type SymbolRow,
  typeOfOperand,
} from './rows';

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

test('rows and columns of a spreadsheet become symbols; a single text is typed', () => {
  const two = [
    { symbol: 'Neu Ä 1', operand: 'E 5.0', type: 'BOOL', comment: 'Komm; 1' },
    { symbol: 'Neu Ä 2', operand: 'MW 50', type: 'INT', comment: '' },
  ];
  const text = 'Neu Ä 1\tE 5.0\tBOOL\tKomm; 1\r\n"Neu Ä 2"\tMW 50\tINT\r\n\r\n';
  expect(pastedRows(text, 'symbol')).toEqual(two);
  expect(pastedRows(text, 'comment')).toEqual(two);
  expect(pastedRows('E 1.0\tBOOL\nE 1.1\tBOOL', 'operand')).toEqual([
    { symbol: '', operand: 'E 1.0', type: 'BOOL', comment: '' },
    { symbol: '', operand: 'E 1.1', type: 'BOOL', comment: '' },
  ]);
  // Quotation marks of a source, doubled by a spreadsheet; one column more than there are.
  expect(pastedRows('"""Start"""\tE 1.0\tBOOL\tKomm\tmore', 'operand')).toEqual([
    { symbol: 'Start', operand: 'E 1.0', type: 'BOOL', comment: 'Komm' },
  ]);
  expect(pastedRows('\tE 1.0\tBOOL', 'symbol')[0]).toEqual({ ...emptyRow(), operand: 'E 1.0', type: 'BOOL' });
  for (const typed of ['Motor', 'Motor\n', ' ']) expect(pastedRows(typed, 'symbol')).toEqual([]);
});
