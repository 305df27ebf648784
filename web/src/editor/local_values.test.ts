import { expect, test } from 'vitest';
import { localValues, typesOf } from './local_values';
import { outlineOf } from './listing_outline';
import type { StatusRow } from './status_columns';

const text = `FUNCTION_BLOCK FB 1
VAR_INPUT
  Start : BOOL ;
  Delay : S5TIME ;
  Timer : TIMER ;
END_VAR
VAR
  Edge : BOOL ;
  Box : STRUCT
    Size : INT ;
  END_STRUCT ;
  List : ARRAY [0..3] OF INT ;
END_VAR
BEGIN
NETWORK
m001: UN    #Start;          // U #Delay
      L     #Delay;
      T     #Box.Size;
      L     #List[2];
      S     #Start;
      FN    #Edge;
      R     #Edge;
      U     "Motor";
      U     #Timer;
      L     #Timer;
      CALL  FC 2 (
           in                   := #Delay,  out := #box.size,
           more                 := MW 2);
      L     #Delay;
END_FUNCTION_BLOCK
`;
const lines = text.split('\n');
const [block] = outlineOf('a.awl', text);
const at = (statement: string): number => lines.findIndex((line) => line.includes(statement)) + 1;
const row = (statement: string, sta: string, akku: string, given = {}): StatusRow =>
  [at(statement), '0', sta, '0', akku, '', '', '', '', '', '', given] as unknown as StatusRow;

test('the declared types, by the way to each variable', () => {
  expect(Object.fromEntries(typesOf(block!))).toMatchObject({
    START: 'BOOL',
    'BOX.SIZE': 'INT',
    LIST: 'INT',
  });
});

test('what a statement has seen of its variable: a bit is STA, a value AKKU 1', () => {
  const seen = localValues(lines, block, [
    row('UN    #Start', '1', '00000000'),
    row('L     #Delay;', '1', '00002005'),
    row('T     #Box', '1', '0000FFFB'),
    row('L     #List', '1', '00000007'),
    row('S     #Start', '1', '00000007', { Start: 'FALSE' }),
    row('FN    #Edge', '1', '00000007', { Edge: 'TRUE' }),
    row('R     #Edge', '1', '00000007'),
    row('U     "Motor"', '1', '00000007'),
    row('U     #Timer', '0', '00000007'),
    row('L     #Timer', '0', '0000000A'),
  ]);
  const flat = [...seen].map(([line, values]) => [line, Object.fromEntries(values)]);
  expect(flat).toEqual([
    [at('UN    #Start'), { '#START': '1' }],
    [at('L     #Delay;'), { '#DELAY': 'S5T#5S' }],
    [at('T     #Box'), { '#BOX.SIZE': '-5' }],
    [at('L     #List'), { '#LIST[2]': '7' }],
    [at('S     #Start'), { '#START': '0' }],
    [at('FN    #Edge'), { '#EDGE': '1' }],
    [at('U     #Timer'), { '#TIMER': '0' }],
    [at('L     #Timer'), { '#TIMER': '10' }],
  ]);
});

test('the operands of a CALL stand below it', () => {
  const seen = localValues(lines, block, [row('CALL', '0', '', { IN: 'S5T#50MS', OUT: 'TRUE', MORE: '9' })]);
  expect([...seen].map(([line, values]) => [line, Object.fromEntries(values)])).toEqual([
    [at('in    '), { '#DELAY': 'S5T#50MS', '#BOX.SIZE': '1' }],
  ]);
});

test('nothing of a block that does not run, and of a variable that it does not have', () => {
  expect(localValues(lines, block, null).size).toBe(0);
  expect(
    localValues(['      L     #None;'], block, [[1, '0', '1', '0', '00000001'] as unknown as StatusRow]).size,
  ).toBe(0);
});
