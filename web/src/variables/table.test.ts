import { expect, test } from 'vitest';
import { parseTable, pastedRows, printTable, rangeOf, tablePath } from './table';

const rows = [
  { operand: 'E 0.0', format: 'BOOL', modify: '' },
  { operand: '"Slider; small"', format: 'AUTO', modify: '1' },
  { operand: 'MW 10', format: 'CHAR', modify: "';;'" },
];

test('a table comes back as it was written', () => {
  expect(parseTable(printTable(rows))).toEqual(rows);
});

test('rows without an operand are not kept', () => {
  expect(printTable([{ operand: ' ', format: 'HEX', modify: '' }])).toBe('// operand ; format ; modify value\n');
});

test('comments, empty lines and missing fields are understood', () => {
  expect(parseTable('// x\r\n\r\n T 1 \r\nMW 2;DEC')).toEqual([
    { operand: 'T 1', format: 'AUTO', modify: '' },
    { operand: 'MW 2', format: 'DEC', modify: '' },
  ]);
});

test('a name becomes a file of the project folder', () => {
  expect(tablePath('press 1')).toBe('press 1.vat');
  expect(tablePath('a/../b.VAT')).toBe('a-..-b.VAT');
});

test('lines and columns of a spreadsheet become rows; a single operand is typed text', () => {
  expect(pastedRows('MW 10\tDEC\t5\nE 0.0\r\n"Motor; left"\thex\n')).toEqual([
    { operand: 'MW 10', format: 'DEC', modify: '5' },
    { operand: 'E 0.0', format: 'AUTO', modify: '' },
    { operand: '"Motor; left"', format: 'HEX', modify: '' },
  ]);
  expect(pastedRows('MW 10;something;7')).toEqual([{ operand: 'MW 10', format: 'AUTO', modify: '7' }]);
  expect(pastedRows('MW 10')).toEqual([]);
});

test('a range names each operand in it', () => {
  expect(rangeOf('MW 10..16')).toEqual(['MW 10', 'MW 12', 'MW 14', 'MW 16']);
  expect(rangeOf('E 0.6 .. 1.1')).toEqual(['E 0.6', 'E 0.7', 'E 1.0', 'E 1.1']);
  expect(rangeOf('t 1..3')).toEqual(['t 1', 't 2', 't 3']);
  expect(rangeOf('DB1.DBD 0..8')).toEqual(['DB1.DBD 0', 'DB1.DBD 4', 'DB1.DBD 8']);
  expect(rangeOf('DB1.DBX 0.0..0.1')).toEqual(['DB1.DBX 0.0', 'DB1.DBX 0.1']);
  for (const none of ['MW 10', 'MW 10..8', 'MB 0..5000', 'E 0.0..3', 'E 0..3', '"a..b"', '"a"-"b"'])
    expect(rangeOf(none)).toEqual([]);
});

test('a range names its last operand in full, or is written with a hyphen', () => {
  expect(rangeOf('MW 0..MW 4')).toEqual(['MW 0', 'MW 2', 'MW 4']);
  expect(rangeOf('E 0.6-E 1.0')).toEqual(['E 0.6', 'E 0.7', 'E 1.0']);
  expect(rangeOf('E 0.6 - 1.0')).toEqual(['E 0.6', 'E 0.7', 'E 1.0']);
  expect(rangeOf('MB 0 - 2')).toEqual(['MB 0', 'MB 1', 'MB 2']);
  expect(rangeOf('DB 1.DBW 0 – db1.dbw 2')).toEqual(['DB 1.DBW 0', 'DB 1.DBW 2']);
  for (const none of ['MW 0..MB 4', 'E 0.0-A 0.7', 'DB1.DBW 0..DB2.DBW 4', 'MW 0-']) expect(rangeOf(none)).toEqual([]);
});
