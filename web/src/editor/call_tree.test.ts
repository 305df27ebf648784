import { expect, test } from 'vitest';
import type { BlockRow } from '../connection/protocol';
import { callTree } from './call_tree';

const block = (id: string, ...calls: string[]): BlockRow => ({
  id,
  symbol: '',
  title: '',
  language: id.startsWith('DB') ? 'DB' : 'AWL',
  load: 0,
  work: 0,
  file: '',
  line: 1,
  calls,
  version: '',
  checksum: '',
});
const shown = (...blocks: BlockRow[]) =>
  callTree(blocks).map((row) => `${' '.repeat(row.depth)}${row.id}${row.mark && ` (${row.mark})`}`);

test('from the organization blocks down, a block unfolded once', () => {
  expect(
    shown(block('FC 1', 'FC 2'), block('OB 100'), block('OB 1', 'FC 10', 'FC 1', 'FC 2'), block('FC 2', 'SFC 20')),
  ).toEqual(['OB 1', ' FC 1', '  FC 2', '   SFC 20', ' FC 2 (above)', ' FC 10', 'OB 100']);
});

test('what nobody calls, and what calls itself, says so', () => {
  expect(shown(block('OB 1', 'FC 1'), block('FC 1', 'FC 1'), block('FC 9'), block('DB 1'))).toEqual([
    'OB 1',
    ' FC 1',
    '  FC 1 (recursive)',
    'FC 9 (unused)',
  ]);
});

test('everybody calls everybody: as many rows as calls', () => {
  const ids = Array.from({ length: 60 }, (_, index) => `FC ${index}`);
  expect(shown(block('OB 1', 'FC 0'), ...ids.map((id) => block(id, ...ids))).length).toBeLessThan(60 * 60 + 3);
});
