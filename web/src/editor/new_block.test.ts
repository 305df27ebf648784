import { expect, test } from 'vitest';
import type { BlockNumbers } from './catalogue';
import {
  basesOf,
  blockId,
  blockText,
  calledInstance,
  type DataKind,
  fileOf,
  listingText,
  otherNumbers,
  otherStep5Numbers,
} from './new_block';
import { listingOutline } from './listing_outline';
import { outline } from './outline';

test.each([
  ['fc1', 'FC 1'],
  [' OB  100 ', 'OB 100'],
  ['DB 007', 'DB 7'],
  ['udt 3', 'UDT 3'],
  ['vat1', 'VAT 1'],
  ['FX 1', null],
  ['FC', null],
])('%s is %s', (text, id) => expect(blockId(text)).toBe(id));

test.each(['OB 1', 'FB 2', 'FC 3', 'DB 4'])('%s begins with a text that has it', (id) =>
  expect(outline(blockText(id)).map((block) => block.name)).toEqual([id]),
);

test('what a data block can be made of, in the order of the block tree', () => {
  const blocks = ['SFB 4', 'UDT 2', 'FB 10', 'FC 1', 'FB 2', 'DB 1'].map((id) => ({
    id,
    symbol: `of ${id}`,
    title: '',
  }));
  const ids = (kind: DataKind, called?: string) => basesOf(kind, blocks, called).map(({ id }) => id);
  expect(ids('instance')).toEqual(['FB 2', 'FB 10', 'SFB 4']);
  expect(ids('instance', 'FB 3')).toEqual(['FB 2', 'FB 3', 'FB 10', 'SFB 4']);
  expect(ids('type', 'FB 3')).toEqual(['UDT 2']);
  expect(ids('shared')).toEqual([]);
  expect(basesOf('type', blocks)[0]!.symbol).toBe('of UDT 2');
});

test('an organization block begins with its start information', () =>
  expect(blockText('OB 1', { start: 'VAR_TEMP\nEND_VAR\n' })).toContain('VERSION : 0.1\nVAR_TEMP\nEND_VAR\nBEGIN\n'));

test('a data block may be the instance of a function block (S7-MGR-12)', () =>
  expect(blockText('DB 4', { base: 'FB 2' })).toContain('DATA_BLOCK DB 4 FB 2\n'));

test('a data type has a structure', () =>
  expect(blockText('UDT 1')).toMatch(/^TYPE UDT 1\nSTRUCT\n[^]*END_STRUCT ;\nEND_TYPE\n$/));

test.each([
  ['FC 1', 'fc1.awl'],
  ['UDT 2', 'udt2.awl'],
  ['VAT 1', 'vat1.vat'],
])('%s stands in %s', (id, path) => expect(fileOf(id)).toBe(path));

const numbers: BlockNumbers = { OB: [1, 35], FB: [0, 9], FC: [0, 9], DB: [1, 9] };
test.each([
  ['OB 1', null],
  ['OB 2', '1, 35'],
  ['FC 0', null],
  ['FC 10', '0 … 9'],
  ['DB 0', '1 … 9'],
  ['UDT 10', null],
  ['UDT 70000', '0 … 65535'],
  ['SFB 60', null],
  ['"Box"', null],
  ['', null],
])('instead of %s: %s', (id, others) => expect(otherNumbers(id, numbers)).toBe(others));

test('a data block that a CALL names is the instance of what is called', () => {
  const texts = ['L MW 1', '  call sfb 44 , db20 (\n', 'CALL FB 1, DB 200'];
  expect(calledInstance('DB 20', texts)).toBe('SFB 44');
  expect(calledInstance('DB 200', texts)).toBe('FB 1');
  expect(calledInstance('DB 2', texts)).toBe('');
  expect(calledInstance('FB 20', texts)).toBe('');
});

test('STEP 5 has blocks of its own, in a listing', () => {
  expect(['pb 7', 'SB1', 'fc 1', 'UDT 1', 'vat 1'].map((text) => blockId(text, 'S5'))).toEqual([
    'PB 7',
    'SB 1',
    null,
    null,
    'VAT 1',
  ]);
  expect([fileOf('PB 7', 'S5'), fileOf('VAT 1', 'S5')]).toEqual(['pb7.s5', 'vat1.vat']);
  expect(['OB 64', 'PB 255', 'DB 0'].map(otherStep5Numbers)).toEqual(['0 … 63', null, '1 … 255']);
  for (const id of ['OB 2', 'PB 7', 'SB 1', 'FB 9', 'DB 10'])
    expect(listingOutline(listingText(id)).map((block) => block.name)).toEqual([id]);
});
