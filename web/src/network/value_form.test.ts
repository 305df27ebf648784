import { expect, test } from 'vitest';
import { formOf, pinType, typeOf } from './value_form';

test('a value is written as constants of its type are', () => {
  const written: [type: string, bits: number, text: string][] = [
    ['INT', 0xfffe, '-2'],
    ['INT', 0x00017fff, '32767'],
    ['DINT', 0xfffffffe, '-2'],
    ['REAL', 0x3fc00000, '1.5'],
    ['BYTE', 0x1ff, 'B#16#FF'],
    ['WORD', 5, 'W#16#0005'],
    ['DWORD', 0xfffffffe, 'DW#16#FFFFFFFE'],
    ['S5TIME', 0x0005, 'S5T#50MS'],
    ['S5TIME', 0x2123, 'S5T#2M3S'],
    ['S5TIME', 0, 'S5T#0MS'],
    ['TIME', 3_723_004, 'T#1H2M3S4MS'],
    ['TIME', 0xffffffff, 'T#-1MS'],
    ['COUNTER', 0x0123, 'C#123'],
    ['DATE', 31, 'D#1990-02-01'],
    ['TIME_OF_DAY', 3_723_004, 'TOD#01:02:03.004'],
    ['CHAR', 0x41, "'A'"],
    ['BOOL', 1, '1'],
    ['KT', 0x1010, 'KT 10.1'],
    ['KZ', 0x0007, 'KZ 7'],
    ['KG', 0x01400000, '1'],
    ['KG', 0x01c00000, '-1'],
  ];
  for (const [type, bits, text] of written) expect(formOf(bits, type), `${type} ${bits}`).toBe(text);
});

const place = (box: string, more = {}) => ({ box, pin: 'IN', isOutput: false, bcd: false, ...more });

test('a pin says what it takes and gives', () => {
  expect(pinType(place('S_EVERZ'))).toBe('S5TIME');
  expect(pinType(place('S_ODT', { isOutput: true }))).toBe('INT');
  expect(pinType(place('S_ODT', { isOutput: true, bcd: true }))).toBe('S5TIME');
  expect(pinType(place('SE', { pin: '' }))).toBe('S5TIME');
  expect(pinType(place('SE'))).toBe('KT');
  expect(pinType(place('ZAEHLER'))).toBe('COUNTER');
  expect(pinType(place('Z', { isOutput: true, bcd: true }))).toBe('KZ');
  expect(pinType(place('SC', { pin: '' }))).toBe('COUNTER');
  expect(pinType(place('CMP >=R'))).toBe('REAL');
  expect(pinType(place('>=F'))).toBe('INT');
  expect(pinType(place('SHR_DI', { pin: 'N' }))).toBe('INT');
  expect(pinType(place('I_DI', { isOutput: true }))).toBe('DINT');
  expect(pinType(place('TRUNC'))).toBe('REAL');
  expect(pinType(place('WOR_DW'))).toBe('DWORD');
  expect(pinType(place('MOVE'))).toBeUndefined();
});

test('the declared type counts, then the pin, then the width of the operand', () => {
  expect(typeOf('S5TIME', '#Filter', place('MOVE'))).toBe('S5TIME');
  expect(typeOf('WORD', '"Pause"', place('S_EVERZ'))).toBe('S5TIME');
  expect(typeOf('WORD', '"Mask"', place('MOVE'))).toBe('WORD');
  expect(typeOf(undefined, 'MW 10', place('ADD_I'))).toBe('INT');
  expect(typeOf(undefined, 'MB 5', place('MOVE'))).toBe('BYTE');
  expect(typeOf(undefined, 'MB 5', place('ADD_I', { isOutput: true }))).toBe('BYTE');
  expect(typeOf(undefined, 'DB5.DBD 8', place('MOVE'))).toBe('DWORD');
});
