import { expect, test } from 'vitest';
import { parseCharacters, showCharacters } from './characters';

test('characters are shown with two hexadecimal digits', () => {
  expect(showCharacters([13, 10])).toBe('0D 0A');
  expect(showCharacters(3)).toBe('03');
  expect(showCharacters(null)).toBe('');
});

test('characters are read as a list or as one', () => {
  expect(parseCharacters('0D 0A', true)).toEqual([13, 10]);
  expect(parseCharacters('0x0d,a', true)).toEqual([13, 10]);
  expect(parseCharacters('13', false)).toBe(19);
});

test('what is no character is nothing', () => {
  expect(parseCharacters('CR', true)).toBeUndefined();
  expect(parseCharacters('123', true)).toBeUndefined();
  expect(parseCharacters('0D 0A', false)).toBeUndefined();
});
