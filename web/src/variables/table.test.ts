import { expect, test } from 'vitest';
import { hasOperand, parseTable, pastedRows, printTable, rangeOf, tablePath } from './table';
import { unread } from './unread';

const rows = [
  { operand: 'E 0.0', format: 'BOOL', modify: '' },
  { operand: '"Slider; small"', format: 'AUTO', modify: '1' },
  { operand: 'MW 10', format: 'CHAR', modify: "';;'" },
];

test('a table comes back as it was written', () => {
  expect(parseTable(printTable(rows))).toEqual(rows);
});

test('empty rows at the end are not kept', () => {
  expect(printTable([{ operand: ' ', format: 'HEX', modify: '' }])).toBe('// operand ; format ; modify value\n');
});

test('missing fields are understood', () => {
  expect(parseTable(' T 1 \r\nMW 2;DEC\n\n')).toEqual([
    { operand: 'T 1', format: 'AUTO', modify: '' },
    { operand: 'MW 2', format: 'DEC', modify: '' },
  ]);
});

test('comments and empty lines between the operands stay', () => {
  const lines = '// Drive 1; Anna: "5\nMW 10 ; DEC ; 5\n\n// Drive 2\nMW 12 ; DEC\n';
  expect(printTable(parseTable(lines))).toBe(`// operand ; format ; modify value\n${lines}`);
  const triggers = '// trigger: monitor begin every; modify now every';
  expect(printTable(parseTable(printTable(parseTable(lines), triggers)), triggers).match(/trigger/g)).toHaveLength(1);
});

test('what is not understood stays: trigger lines that say nothing, lines without an operand', () => {
  const lines =
    '// trigger: monitor nix every; modify now once\nMW 10 ; DEC\n; ; ;\n// trigger: what?\nMW 12 ; DEC\n; HEX\n';
  expect(printTable(parseTable(lines))).toBe(`// operand ; format ; modify value\n${lines}`);
  expect(parseTable(lines).filter(hasOperand)).toHaveLength(2);
  const triggers = '// trigger: monitor begin every; modify now every';
  expect(parseTable(`${triggers}\n${triggers}\nMW 2\n`).map(({ operand }) => operand)).toEqual([triggers, 'MW 2']);
});

test('a value that cannot be read has its reason', () => {
  const text = '?';
  expect(unread({ text, address: 'DB99.DBW 0', sent: true })).toMatch(/DB 99/);
  expect(unread({ text, address: 'PEW 256', sent: true })).toMatch(/Baugruppe|module/);
  expect(unread({ text, address: 'DB99.DBW 0' })).toBe('');
  expect(unread({ text: 'W#16#0000', address: 'DB1.DBW 0', sent: true })).toBe('');
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
  expect(pastedRows('// Motor\nMB 1..2 ; HEX\n').map(({ operand, format }) => `${operand} ${format}`)).toEqual([
    '// Motor AUTO',
    'MB 1 HEX',
    'MB 2 HEX',
  ]);
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
