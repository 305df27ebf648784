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
  it('takes the first word of a header as the name, whatever follows it', () => {
    const headers: [string, string][] = [
      ['DATA_BLOCK DB 41 SFB 41', 'DB 41'],
      ['DATA_BLOCK DB 10 FB 10 // data of the press', 'DB 10'],
      ['DATA_BLOCK (* data *) DB10 UDT 3;', 'DB10'],
      ['data_block db  4 "Slider"', 'db 4'],
      ['DATA_BLOCK "Small: boxes" "Slider"', '"Small: boxes"'],
      ['DATA_BLOCK"Pump"', '"Pump"'],
      ['DATA_BLOCK DB 5 STRUCT', 'DB 5'],
      ['DATA_BLOCK', ''],
      ['FUNCTION_BLOCK FB 10 TITLE = FB 11 : pump', 'FB 10'],
      ['FUNCTION_BLOCK FB 11 VERSION : 1.0', 'FB 11'],
      ["FUNCTION FC 3 { S7_x := 'a' } : INT", 'FC 3'],
      ['FUNCTION FC 4 : VOID // FC 5', 'FC 4'],
      ['ORGANIZATION_BLOCK OB\t1', 'OB 1'],
      ['TYPE UDT 7', 'UDT 7'],
    ];
    for (const [header, name] of headers) expect(outline(header)[0]!.name, header).toBe(name);
    expect(outline('DATA_BLOCK // of the press\n  DB 8\n  FB 8\nBEGIN\nEND_DATA_BLOCK')[0]!.name).toBe('DB 8');
  });
  it('reads on in the line of a header', () => {
    const [first, second, third] = outline(`FUNCTION_BLOCK FB 10 TITLE = Pump: one
VERSION : 1.0
END_FUNCTION_BLOCK
DATA_BLOCK DB 1 FB 10 BEGIN END_DATA_BLOCK
FUNCTION_BLOCK FB 11 VAR_INPUT
  Name : INT ;
END_VAR
`);
    expect(first).toMatchObject({ title: 'Pump: one', end: 3 });
    expect(second).toMatchObject({ name: 'DB 1', begin: 4, end: 4 });
    expect(third!.declarations.map(({ name }) => name)).toEqual(['Name']);
  });
});
