import { expect, test } from 'vitest';
import type { Texts } from './index';

const modules = import.meta.glob<Record<string, Texts>>('./texts/*.ts', { eager: true });
const entries = Object.entries(modules).flatMap(([path, module]) =>
  Object.values(module).flatMap((texts) =>
    Object.entries(texts).map(([key, text]) => [`${path}: ${key}`, text] as const),
  ),
);
const places = (text: string) => (text.match(/\{\w+\}/g) ?? []).sort();

test('there are texts', () => expect(entries.length).toBeGreaterThan(20));

test.each(entries)('%s is said in both languages', (_, text) => {
  expect(text.length).toBe(2);
  for (const one of text) expect(one.trim()).not.toBe('');
  expect(places(text[0])).toEqual(places(text[1]));
});
