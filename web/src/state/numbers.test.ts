import { expect, test } from 'vitest';
import { language } from '../i18n';
import { duration, milliseconds } from './numbers';

test('virtual time is read as a clock', () => {
  expect(duration(0)).toBe('0:00:00.000');
  expect(duration(3_723_004_999_999)).toBe('1:02:03.004');
});

test('a cycle time does not pretend to be more exact than the CPU', () => {
  expect(milliseconds(0)).toBe('< 1 ms');
  expect(milliseconds(12)).toBe('12 ms');
  expect(milliseconds(1.314)).toBe('1.31 ms');
  language.value = 'de';
  expect(milliseconds(1.314)).toBe('1,31 ms');
});
