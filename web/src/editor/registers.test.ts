import { expect, test } from 'vitest';
import { registerName, registerValue } from './registers';

test('registers have the names of the language, and no number says "DB" twice', () => {
  expect(registerName('AKKU1', 'de')).toBe('AKKU1');
  expect(registerName('AKKU1', 'en')).toBe('ACCU1');
  expect(registerName('STW', 'en')).toBe('STW');
  expect(registerValue('DB 20')).toBe('20');
  expect(registerValue('-')).toBe('-');
  expect(registerValue('0000FFFF')).toBe('0000FFFF');
});
