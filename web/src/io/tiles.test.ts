import { expect, test } from 'vitest';
import { formatsOf } from '../state/formats';
import { bitsOf, parseTile, rangeOf, sliderValue, tilesOfSymbols } from './tiles';

test.each([
  ['eb0', 'EB 0', 'channels', 8],
  ['QB 1', 'QB 1', 'channels', 8],
  ['mw 010', 'MW 10', 'value', 16],
  ['PEW 752', 'PEW 752', 'value', 16],
  ['MD20', 'MD 20', 'value', 32],
  ['t1', 'T 1', 'timer', 16],
  ['C 3', 'C 3', 'counter', 16],
  ['db 7.dbw 4', 'DB7.DBW 4', 'value', 16],
])('%s is the tile %s (S7-SIM-03)', (text, operand, kind, bits) => {
  expect(parseTile(text)).toMatchObject({ operand, kind, bits });
});

test.each(['', 'E 0.0', 'EB', 'XB 1', 'DB 1', 'MW -1', 'T 1.0'])('"%s" is no tile', (text) => {
  expect(parseTile(text)).toBeUndefined();
});

test('a byte has its eight bits, peripheral bytes have none', () => {
  expect(bitsOf(parseTile('EB 4')!)).toContain('E 4.7');
  expect(bitsOf(parseTile('DB1.DBB 2')!)[0]).toBe('DB1.DBX 2.0');
  expect(bitsOf(parseTile('PEB 4')!)).toEqual([]);
});

test('formats fit the width (S7-SIM-12)', () => {
  expect(formatsOf(16)).toContain('S5TIME');
  expect(formatsOf(16)).not.toContain('REAL');
  expect(formatsOf(32)).toContain('REAL');
  expect(formatsOf(8)).not.toContain('S5TIME');
  expect(formatsOf(1)).toEqual(['AUTO', 'BOOL', 'BIN', 'HEX', 'UDEC']);
  expect(formatsOf(0).length).toBe(16);
});

test('the slider of DEC is signed', () => {
  expect(rangeOf(16, 'DEC')).toEqual([-32768, 32767]);
  expect(rangeOf(16, 'HEX')).toEqual([0, 65535]);
  expect(sliderValue(0xffff, 16, 'DEC')).toBe(-1);
  expect(sliderValue(0xffff, 16, 'HEX')).toBe(65535);
});

test('the first tiles are those that have symbols', () => {
  const tiles = tilesOfSymbols(['A 1.0', 'Z 2', 'E 0.1', 'E 0.0', 'FC 1', 'M 1.0', 'T 1']);
  expect(tiles.map((tile) => tile.operand)).toEqual(['EB 0', 'AB 1', 'T 1', 'Z 2']);
});
