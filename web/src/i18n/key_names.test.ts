import { expect, test } from 'vitest';
import { keyNames } from './key_names';

test('keys have the names of their keyboard', () => {
  expect(keyNames('Ctrl Shift F', 'de')).toBe('Strg Umschalt F');
  expect(keyNames('Ctrl Del', 'de')).toBe('Strg Entf');
  expect(keyNames('Home End', 'de')).toBe('Pos1 Ende');
  expect(keyNames('Ctrl Del', 'en')).toBe('Ctrl Del');
  expect(keyNames('Alt 1…9, 0', 'de')).toBe('Alt 1…9, 0');
});
