import { describe, expect, it } from 'vitest';
import { allowedDeclarations, blockAt, declarationText, outline } from './outline';

const source = `// Slider
FUNCTION_BLOCK "Slider"
TITLE = One slider
VERSION : 1.0
VAR_INPUT
  Box : BOOL := TRUE ;   // box there
  Time {S7_x := 'a'} : S5TIME ;
END_VAR
VAR
  Data : STRUCT
    Low : INT := 5;
  END_STRUCT ;
  Values : ARRAY [1..4] OF WORD ;
END_VAR
BEGIN
NETWORK
TITLE = First
M001: U #Box;
NETWORK
      SPA M001;
END_FUNCTION_BLOCK
FUNCTION FC 1 : VOID
BEGIN
END_FUNCTION
`;

describe('outline of a source', () => {
  const [slider, function1] = outline(source);
  it('finds blocks, titles and networks', () => {
    expect(slider).toMatchObject({
      keyword: 'FUNCTION_BLOCK',
      name: '"Slider"',
      title: 'One slider',
      line: 2,
      begin: 15,
      end: 21,
    });
    expect(slider!.networks).toEqual([
      { line: 16, title: 'First' },
      { line: 19, title: '' },
    ]);
    expect(slider!.labels).toEqual(['M001']);
    expect(function1).toMatchObject({ keyword: 'FUNCTION', name: 'FC 1', line: 22 });
  });
  it('reads the declarations (S7-EDIT-02)', () => {
    expect(
      slider!.declarations.map((row) => [row.declaration, row.name, row.type, row.initial, row.comment, row.depth]),
    ).toEqual([
      ['in', 'Box', 'BOOL', 'TRUE', 'box there', 0],
      ['in', 'Time', 'S5TIME', '', '', 0],
      ['stat', 'Data', 'STRUCT', '', '', 0],
      ['stat', 'Low', 'INT', '5', '', 1],
      ['stat', 'Values', 'ARRAY [1..4] OF WORD', '', '', 0],
    ]);
    expect(slider!.sections).toEqual([
      { declaration: 'in', line: 5, end: 8 },
      { declaration: 'stat', line: 9, end: 14 },
    ]);
  });
  it('tells the block of a line', () => {
    const blocks = outline(source);
    expect(blockAt(blocks, 18)?.name).toBe('"Slider"');
    expect(blockAt(blocks, 1)).toBeUndefined();
  });
  it('offers the declarations a block may have (S7-EDIT-03)', () => {
    expect(allowedDeclarations('FUNCTION')).not.toContain('stat');
    expect(allowedDeclarations('ORGANIZATION_BLOCK')).toEqual(['temp']);
    expect(allowedDeclarations('DATA_BLOCK')).toEqual([]);
  });
  it('writes a declaration that it reads again', () => {
    const row = { name: 'Count', type: 'INT', initial: '5', comment: 'boxes' };
    const [block] = outline(`FUNCTION FC 1 : VOID\nVAR_TEMP\n${declarationText(row)}\nEND_VAR\n`);
    expect(block!.declarations[0]).toMatchObject(row);
  });
});
