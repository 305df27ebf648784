import { expect, test } from 'vitest';
import { keep, keptReplaced, type Replaced } from './replaced';

const kept = new Map<string, string>();
const storage = {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => void kept.set(key, value),
  removeItem: (key: string) => void kept.delete(key),
  length: 0,
  key: () => null,
};
const replaced = (text: string): Replaced => ({
  folder: '/p',
  count: 1,
  changes: [{ file: 'a.awl', before: text, after: `${text}!` }],
});

test('what was replaced last is known after a reload, until it is taken back', () => {
  expect(keptReplaced(storage)).toBe(null);
  keep(storage, replaced('U E 0.0'));
  expect(keptReplaced(storage)).toEqual(replaced('U E 0.0'));
  keep(storage, null);
  expect(keptReplaced(storage)).toBe(null);
});

test('more than a browser should keep is not kept, and nothing older in its place', () => {
  keep(storage, replaced('U E 0.0'));
  keep(storage, replaced('x'.repeat(600_000)));
  expect(kept.size).toBe(0);
});

test('a browser that keeps nothing, or something else, does no harm', () => {
  const full = {
    ...storage,
    setItem: () => {
      throw new Error('full');
    },
  };
  keep(full, replaced('U E 0.0'));
  kept.set('merker.replaced', '{');
  expect(keptReplaced(storage)).toBe(null);
});
