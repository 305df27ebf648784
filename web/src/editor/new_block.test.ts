import { expect, test } from 'vitest';
import { blockId, blockText, typeName } from './new_block';
import { outline } from './outline';

test.each([
  ['fc1', 'FC 1'],
  [' OB  100 ', 'OB 100'],
  ['DB 007', 'DB 7'],
  ['FX 1', null],
  ['FC', null],
])('%s is %s', (text, id) => expect(blockId(text)).toBe(id));

test.each(['OB 1', 'FB 2', 'FC 3', 'DB 4'])('%s begins with a text that has it', (id) =>
  expect(outline(blockText(id)).map((block) => block.name)).toEqual([id]),
);

test.each([
  ['fb1', 'FB 1'],
  ['udt 02', 'UDT 2'],
  ['"Box"', '"Box"'],
  ['FC 1', null],
])('%s as type of a data block is %s', (text, type) => expect(typeName(text)).toBe(type));

test('a data block may be the instance of a function block (S7-MGR-12)', () =>
  expect(blockText('DB 4', 'FB 2')).toContain('DATA_BLOCK DB 4 FB 2\n'));
