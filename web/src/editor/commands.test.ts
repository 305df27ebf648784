import { expect, test } from 'vitest';
import { commandOf } from './commands';

const press = (key: string, more = {}) =>
  commandOf({ key, ctrlKey: true, metaKey: false, altKey: false, shiftKey: false, ...more });

test('Ctrl S saves, Ctrl L loads and Ctrl R goes into the networks, also with Caps Lock and on a Mac', () => {
  expect(press('s')).toBe('save');
  expect(press('L')).toBe('load');
  expect(press('r')).toBe('enter');
  expect(press('s', { ctrlKey: false, metaKey: true })).toBe('save');
});

test('with other keys held down they are something else', () => {
  for (const more of [{ ctrlKey: false }, { altKey: true }, { shiftKey: true }])
    expect(press('s', more)).toBeUndefined();
  expect(press('q')).toBeUndefined();
});
