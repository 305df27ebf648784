import { expect, test } from 'vitest';
import { blockId, blockText } from './new_block';
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

test('a data block may be the instance of a function block (S7-MGR-12)', () =>
  expect(blockText('DB 4', 'FB 2')).toContain('DATA_BLOCK DB 4 FB 2\n'));
