import { expect, test } from 'vitest';
import { parseTable, printTable, tablePath } from './table';

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
