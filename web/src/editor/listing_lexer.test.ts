import { expect, test } from 'vitest';
import { listingStart, nextOfListing } from './listing_lexer';

function kinds(line: string): string[] {
  const state = listingStart();
  const list: string[] = [];
  for (let at = 0; at < line.length; ) {
    const { length, kind } = nextOfListing(line.slice(at), state);
    if (kind !== 'space') list.push(`${kind} ${line.slice(at, at + length).trim()}`);
    at += length;
  }
  return list;
}

test.each([
  ['OB 1', ['keyword OB 1']],
  ['NETZWERK 1  both buttons', ['keyword NETZWERK 1', 'text both buttons']],
  [' :      U    E 1.0   ! a 5', ['punctuation :', 'instruction U', 'operand E 1.0', 'comment ! a 5']],
  ['M1   :  S    A 2.0', ['label M1   :', 'instruction S', 'operand A 2.0']],
  [' : !=F', ['punctuation :', 'instruction !=F']],
  [' : SPB =M1', ['punctuation :', 'instruction SPB', 'symbol =M1']],
  [' : L KF +25', ['punctuation :', 'instruction L', 'type KF', 'number +25']],
  ['   0 :  KH = 1F00', ['number 0 :', 'type KH =', 'number 1F00']],
  ['// all of it', ['comment // all of it']],
])('%s', (line, expected) => expect(kinds(line)).toEqual(expected));
