import { expect, test } from 'vitest';
import { listingOutline, outlineOf } from './listing_outline';

const source = `// A comment of the file
OB 1                     ! each cycle
NETZWERK 1  both buttons
 :      U    E 1.0
 :      SPA  FB 5
NAME :  VENTIL
PB   :  E 2.0
fb 5
NAME :  VENTIL
SEGMENT 1
 :      T    PB 1
 :      BE
FB 6   WEG   BIB=14050
 : BE
DB 10 ; three words
   0 :  KH = 1F00`;

test('blocks of a listing, each to the line before the next', () => {
  expect(listingOutline(source).map((one) => [one.name, one.title, one.line, one.end])).toEqual([
    ['OB 1', '', 2, 7],
    ['FB 5', 'VENTIL', 8, 12],
    ['FB 6', 'WEG', 13, 14],
    ['DB 10', '', 15, 16],
  ]);
});

test('its networks with their titles', () => {
  const [ob, fb] = listingOutline(source);
  expect(ob!.networks).toEqual([{ line: 3, title: 'both buttons' }]);
  expect(fb!.networks).toEqual([{ line: 10, title: '' }]);
});

test('a data block has no code', () => {
  expect(listingOutline(source).map((one) => one.hasCode)).toEqual([true, true, true, false]);
});

test('the name of the file says whether it is a listing', () => {
  expect(outlineOf('main.S5', 'PB 1\n : BE')).toHaveLength(1);
  expect(outlineOf('main.awl', 'PB 1\n : BE')).toHaveLength(0);
});
