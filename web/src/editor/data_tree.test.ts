import { expect, test } from 'vitest';
import type { DataRow } from '../connection/protocol';
import { arrayTypes, dataTree, groupsOf, partsOf, structureTypes } from './data_tree';

const row = (path: string, address: string): DataRow => ({
  operand: `DB2.${path}`,
  format: 'AUTO',
  address,
  path,
  type: 'INT',
  section: '',
  initial: '0',
  actual: '0',
  comment: '',
});
const rows = [row('run', '0.0'), row('list[1].x', '2.0'), row('list[1].y', '4.0'), row('list[2].x', '6.0')];
const shown = (open: string[]) =>
  dataTree(rows, new Set(open)).map(
    (node) => `${' '.repeat(node.depth)}${node.name} ${node.kind ?? node.row!.address}`,
  );

test('a path has its parts, each with the way to it', () => {
  expect(partsOf('a.b[1,2].c').map(({ name, key }) => `${name}=${key}`)).toEqual([
    'a=a',
    'b=a.b',
    '[1,2]=a.b[1,2]',
    'c=a.b[1,2].c',
  ]);
});

test('a structure is declared where its elements are, which say it no more', () => {
  const declared = rows.map((one) => ({ ...one, section: 'STAT' }));
  const sections = dataTree(declared, new Set(['list', 'list[1]'])).map(({ name, section }) => `${name} ${section}`);
  expect(sections).toEqual(['run STAT', 'list STAT', '[1] ', 'x ', 'y ', '[2] ']);
});

test('structures and arrays are folded until somebody opens them', () => {
  expect(shown([])).toEqual(['run 0.0', 'list ARRAY']);
  expect(shown(['list'])).toEqual(['run 0.0', 'list ARRAY', ' [1] STRUCT', ' [2] STRUCT']);
  expect(shown(['list', 'list[1]'])).toEqual([
    'run 0.0',
    'list ARRAY',
    ' [1] STRUCT',
    '  x 2.0',
    '  y 4.0',
    ' [2] STRUCT',
  ]);
  // What lies in something folded stays out of sight, whatever else is open.
  expect(shown(['list[1]'])).toEqual(['run 0.0', 'list ARRAY']);
});

test('everything can be unfolded at once', () => {
  expect(groupsOf(rows)).toEqual(['list', 'list[1]', 'list[2]']);
  expect(dataTree(rows, new Set(groupsOf(rows)))).toHaveLength(7);
});

test('an array says its bounds and what it is of, as far as the rows go', () => {
  const more = [
    ...rows,
    row('grid[1,0]', '8.0'),
    row('grid[1,1]', '10.0'),
    row('grid[2,0]', '12.0'),
    row('grid[2,1]', '14.0'),
  ];
  expect([...arrayTypes(more, true)]).toEqual([
    ['list', 'ARRAY[1..2] OF STRUCT'],
    ['grid', 'ARRAY[1..2, 0..1] OF INT'],
  ]);
  expect([...arrayTypes(more, false).keys()]).toEqual(['list']);
});

test('a structure is its data type, also as the element of an array', () => {
  const type = structureTypes([
    { path: 'list[]', type: '"Motor"' },
    { path: 'list[].drive', type: 'UDT 2' },
  ]);
  expect(['list[1]', 'list[1].drive', 'list', 'other'].map(type)).toEqual(['"Motor"', 'UDT 2', 'STRUCT', 'STRUCT']);
  expect([...arrayTypes(rows, true, type)]).toEqual([['list', 'ARRAY[1..2] OF "Motor"']]);
});
