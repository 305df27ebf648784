import { expect, test } from 'vitest';
import type { BlockRow } from '../connection/protocol';
import { compareIds, treeRows } from './block_tree';

const block = (id: string, calls: string[] = []): BlockRow => ({
  id,
  calls,
  symbol: '',
  title: '',
  language: 'AWL',
  load: 0,
  work: 0,
  file: '',
  line: 0,
  version: '',
  checksum: '',
});
const blocks = [block('FC 10'), block('FC 2', ['FC 10']), block('DB 1'), block('OB 1', ['FC 2', 'FC 99'])];
const shown = (...open: string[]): string[] =>
  treeRows(blocks, new Set(open)).map((row) => `${' '.repeat(row.depth)}${row.id}`);

test('blocks stand in the order OB, FB, FC, DB and by number', () =>
  expect(shown()).toEqual(['OB 1', 'FC 2', 'FC 10', 'DB 1']));

test('those of STEP 5: OB, PB, SB, FB, DB', () =>
  expect(['DB 1', 'FB 1', 'SB 9', 'PB 10', 'PB 2', 'OB 1'].sort(compareIds).join()).toBe(
    'OB 1,PB 2,PB 10,SB 9,FB 1,DB 1',
  ));

test('an open block shows what it calls, also what is missing', () =>
  expect(shown('OB 1', 'OB 1/FC 2')).toEqual(['OB 1', ' FC 2', '  FC 10', ' FC 99', 'FC 2', 'FC 10', 'DB 1']));

test('a recursion ends', () => {
  const loop = [block('FC 1', ['FC 1'])];
  const rows = treeRows(loop, new Set(['FC 1', 'FC 1/FC 1', 'FC 1/FC 1/FC 1']));
  expect(rows.map((row) => row.expandable)).toEqual([true, false]);
});
