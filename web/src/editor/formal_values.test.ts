import { expect, test } from 'vitest';
import { formalValues } from './formal_values';
import { outlineOf } from './listing_outline';
import { operandsIn, operandsOf } from './nearby';
import type { StatusRow } from './status_columns';

const text = `FB 20
NAME : SUCHEN
BEZ  : EIN   E/A/D/B/T/Z: E   BI/BY/W/D: BI
BEZ  : WZNR  E/A/D/B/T/Z: E   BI/BY/W/D: BY
BEZ  : PLTZ  A W
BEZ  : ZAHL  E/A/D/B/T/Z: D   KM/KH/KY/KC/KT/KZ/KF/KG: KF
BEZ  : ZEIT  E/A/D/B/T/Z: T
NETZWERK 1
 : U    =EIN
ANF  : L    =WZNR            ! L =EIN
 : T    =PLTZ
 : L    =ZAHL
 : LC   =ZEIT
 : SPB  =ANF
:=     =EIN
 : S    =EIN
 : BE
`;
const lines = text.split('\n');
const [block] = outlineOf('a.s5', text);
const at = (statement: string): number => lines.findIndex((line) => line.includes(statement)) + 1;
const row = (statement: string, sta: string, akku: string): StatusRow =>
  [at(statement), '0', sta, '0', akku, '', '', '', '', '', '', {}] as unknown as StatusRow;

test('a bit is STA, a value AKKU 1 in the form of its declaration; a jump has none, and S shows another bit', () => {
  const seen = formalValues(lines, block, [
    row('U    =EIN', '1', '00000000'),
    row('L    =WZNR', '1', '0000001F'),
    row('T    =PLTZ', '1', '00001A2B'),
    row('L    =ZAHL', '1', '0000FFFB'),
    row('LC   =ZEIT', '1', '00001010'),
    row('SPB  =ANF', '1', '00001010'),
    row(':=     =EIN', '0', '00001010'),
    row('S    =EIN', '1', '00001010'),
  ]);
  expect([...seen].map(([line, values]) => [line, Object.fromEntries(values)])).toEqual([
    [at('U    =EIN'), { '=EIN': '1' }],
    [at('L    =WZNR'), { '=WZNR': 'KH 1F' }],
    [at('T    =PLTZ'), { '=PLTZ': 'KH 1A2B' }],
    [at('L    =ZAHL'), { '=ZAHL': 'KF -5' }],
    [at('LC   =ZEIT'), { '=ZEIT': 'KT 10.1' }],
    [at(':=     =EIN'), { '=EIN': '0' }],
  ]);
});

test('nothing of a block that does not run', () => {
  expect(formalValues(lines, block, null).size).toBe(0);
});

test('they are operands of their line, and none that others can be asked for', () => {
  expect(operandsOf(' : U    =EIN')).toEqual([{ written: '=EIN', end: 12 }]);
  expect(operandsOf('      CALL FC 1 (a :=TRUE);')).toEqual([]);
  expect(operandsIn([' : U    =EIN', ' : U    E 1.0'], () => false)).toEqual(['E 1.0']);
});
