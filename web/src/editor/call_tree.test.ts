import { expect, test } from 'vitest';
import type { BlockRow, StructureRow, UsedBlock } from '../connection/protocol';
import { callTree, deepest } from './call_tree';

const used = (text: string): UsedBlock => {
  const [id = '', instance] = text.split(', ');
  const from = id.startsWith('SFC') ? 'cpu' : id.endsWith('9') ? 'missing' : 'program';
  return instance ? { id, instance, from } : { id, from };
};
const block = (id: string, ...uses: string[]): StructureRow => ({ id, local: 10, uses: uses.map(used) });
const shown = (...structure: StructureRow[]) =>
  callTree([], structure).map(
    (row) =>
      `${' '.repeat(row.depth)}${[row.id, row.instance].filter(Boolean).join(', ')}${row.mark && ` (${row.mark})`}`,
  );

test('from the organization blocks down, a block unfolded once', () => {
  expect(
    shown(
      block('FC 1', 'FC 2'),
      block('OB 100'),
      block('OB 1', 'FC 10', 'FC 1', 'FC 2'),
      block('FC 2', 'SFC 20'),
      block('FC 10'),
    ),
  ).toEqual(['OB 1', ' FC 1', '  FC 2', '   SFC 20 (ofCpu)', ' FC 2 (above)', ' FC 10', 'OB 100']);
});

test('what nobody calls, what calls itself, and what is not there says so', () => {
  expect(shown(block('OB 1', 'FC 1', 'FC 9'), block('FC 1', 'FC 1'), block('FC 8'))).toEqual([
    'OB 1',
    ' FC 1',
    '  FC 1 (recursive)',
    ' FC 9 (missing)',
    'FC 8 (unused)',
  ]);
});

test('instances stand at their calls, data blocks are leaves', () => {
  expect(shown(block('OB 1', 'FB 1, DB 12', 'DB 3', 'FB 1, DB 11'), block('FB 1', 'DB 3'))).toEqual([
    'OB 1',
    ' FB 1, DB 11',
    '  DB 3',
    ' FB 1, DB 12 (above)',
    ' DB 3',
  ]);
});

test('a data block that nobody opens says so; a library block is none of the CPU', () => {
  const rows = ['OB 1', 'DB 10', 'DB 2', 'DB 3', 'FB 1'].map((id) => ({ id }) as BlockRow);
  const library: UsedBlock = { id: 'FC 97', from: 'library' };
  const structure = [{ id: 'OB 1', uses: [used('FB 1, DB 3'), used('DB 2'), library] }, block('FB 1')];
  expect(callTree(rows, structure).map(({ id, mark }) => `${id} ${mark}`.trim())).toEqual([
    'OB 1',
    'FB 1',
    'FC 97 ofLibrary',
    'DB 2',
    'DB 10 unopened',
  ]);
});

test('local data of the block and of the path to it; none where there is none', () => {
  const blocks = [block('OB 1', 'FC 1', 'DB 1'), block('FC 1', 'FC 2'), block('FC 2')];
  const bytes = (rows: StructureRow[]) => callTree([], rows).map(({ id, local, path }) => `${id} ${local} ${path}`);
  expect(bytes(blocks)).toEqual(['OB 1 10 10', 'FC 1 10 20', 'FC 2 10 30', 'DB 1 undefined undefined']);
  expect(bytes(blocks.map(({ id, uses }) => ({ id, uses })))[2]).toBe('FC 2 undefined undefined');
});

test('the longest path of an organization block, also where the tree is folded and where a block calls itself', () => {
  const blocks = [
    block('OB 1', 'FC 1', 'FC 2'),
    block('FC 1'),
    block('FC 2', 'FC 1', 'FC 2', 'FC 3'),
    block('FC 3', 'FC 1'),
  ];
  expect(deepest(blocks)('OB 1')).toBe(40);
  expect(deepest(blocks)('DB 1')).toBe(undefined);
});

test('everybody calls everybody: as many rows as calls', () => {
  const ids = Array.from({ length: 60 }, (_, index) => `FC ${index}`);
  const all = [block('OB 1', 'FC 0'), ...ids.map((id) => block(id, ...ids))];
  expect(shown(...all).length).toBeLessThan(60 * 60 + 3);
  expect(deepest(all)('OB 1')).toBe(610);
});
