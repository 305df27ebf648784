import { expect, test } from 'vitest';
import { addRow, removeRow, replaceRow } from './declarations';
import { outline } from './outline';

const source = `FUNCTION FC 1 : VOID
VAR_INPUT
  Start : BOOL ;
END_VAR
BEGIN
END_FUNCTION`;
const rows = (text: string): string[] =>
  outline(text)[0]!.declarations.map((row) =>
    [row.declaration, row.name, row.type, row.initial, row.comment].join(' ').trim(),
  );

test('a cell of the table changes its line only', () => {
  const row = outline(source)[0]!.declarations[0]!;
  const text = replaceRow(source, row, { type: 'INT', initial: '5', comment: 'how many' });
  expect(rows(text)).toEqual(['in Start INT 5 how many']);
  expect(text.split('\n').length).toBe(source.split('\n').length);
  expect(rows(removeRow(source, row))).toEqual([]);
});

test('a new variable goes to its section, or makes it', () => {
  const more = addRow(source, outline(source)[0]!, 'in');
  expect(rows(more)).toEqual(['in Start BOOL', 'in Var1 BOOL']);
  const temp = addRow(more, outline(more)[0]!, 'temp');
  expect(rows(temp)).toEqual(['in Start BOOL', 'in Var1 BOOL', 'temp Var2 BOOL']);
  const out = addRow(temp, outline(temp)[0]!, 'out');
  expect(rows(out).map((row) => row.split(' ')[0])).toEqual(['in', 'in', 'out', 'temp']);
});

test('a block without any section gets its first one', () =>
  expect(
    rows(
      addRow(
        'ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK',
        outline('ORGANIZATION_BLOCK OB 1\nBEGIN\n')[0]!,
        'temp',
      ),
    ),
  ).toEqual(['temp Var1 BOOL']));

test('an OB has temporary variables only (S7-EDIT-03)', () => {
  const ob = 'ORGANIZATION_BLOCK OB 1\nBEGIN\n';
  expect(addRow(ob, outline(ob)[0]!, 'stat')).toBe(ob);
});
