import { describe, expect, it } from 'vitest';
import { convertSource, mnemonicsOf, operandIn, sameOperand } from './mnemonics';

const german = `FUNCTION FC 1 : VOID
TITLE = Start U E 0.0
BEGIN
NETWORK
M001: U     E 0.0;   // U stays in a comment
      UN(;
      L     PEW 256;
      SE    T 1;
      ZV    Z 2;
      T     AW 4;
      )     ;
      SPBNB M001;
      U     BIE;
      =     "Motor";
END_FUNCTION
`;

const international = `FUNCTION FC 1 : VOID
TITLE = Start U E 0.0
BEGIN
NETWORK
M001: A     I 0.0;   // U stays in a comment
      AN(;
      L     PIW 256;
      SD    T 1;
      CU    C 2;
      T     QW 4;
      )     ;
      JNB M001;
      A     BR;
      =     "Motor";
END_FUNCTION
`;

describe('mnemonics (S7-EDIT-24)', () => {
  it('turns German into international', () => expect(convertSource(german, 'international')).toBe(international));
  it('turns international into German', () =>
    expect(convertSource(international.replace('JNB M001', 'JNB   M001'), 'german')).toBe(german));
  it('leaves what is already so', () => expect(convertSource(german, 'german')).toBe(german));
  it('recognises what a source is written in', () => {
    expect(mnemonicsOf(german)).toBe('german');
    expect(mnemonicsOf(international)).toBe('international');
  });
  it('has an operand in the words of a text', () => {
    const words = ['E 0.0', 'AB 4', 'PEW 752', 'Z 1', 'M 1.0', 'DB1.DBW 0', 'plant.Belt.A', '"A 1"'];
    const others = ['I 0.0', 'QB 4', 'PIW 752', 'C 1', 'M 1.0', 'DB1.DBW 0', 'plant.Belt.A', '"A 1"'];
    expect(words.map((one) => operandIn(one, 'international'))).toEqual(others);
    expect([...others, ...words].map((one) => operandIn(one, 'german'))).toEqual([...words, ...words]);
  });
  it('compares operands without blanks and in one setting', () => {
    expect(sameOperand('I 0.0')).toBe(sameOperand('E0.0'));
    expect(sameOperand('QW 4')).toBe('AW4');
    expect(sameOperand('FC 1')).toBe('FC1');
  });
});
