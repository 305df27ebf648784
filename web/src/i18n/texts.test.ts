import { expect, test } from 'vitest';
import { filled, type Texts } from './index';

const modules = import.meta.glob<Record<string, Texts>>('./texts/*.ts', { eager: true });
const entries = Object.entries(modules).flatMap(([path, module]) =>
  Object.values(module).flatMap((texts) =>
    Object.entries(texts).map(([key, text]) => [`${path}: ${key}`, text] as const),
  ),
);
const places = (text: string) => [...new Set((text.match(/\{\w+/g) ?? []).sort())];

test('there are texts', () => expect(entries.length).toBeGreaterThan(20));

test.each(entries)('%s is said in both languages', (_, text) => {
  expect(text.length).toBe(2);
  for (const one of text) expect(one.trim()).not.toBe('');
  expect(places(text[0])).toEqual(places(text[1]));
});

test('a number takes its word', () => {
  const text = '{count} {count|place|places} in {file}';
  expect(filled(text, { count: 1, file: 'a' })).toBe('1 place in a');
  expect(filled(text, { count: 0, file: 'a' })).toBe('0 places in a');
  expect(filled('{other}', {})).toBe('{other}');
});
