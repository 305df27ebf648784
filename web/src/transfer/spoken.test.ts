import { expect, test, vi } from 'vitest';

vi.mock('../i18n', async () => {
  const { phrase, problemText } = await import('../i18n/phrases');
  type Told = { code: string; text: string; arguments?: string[] };
  return { said: phrase, told: (one: Told) => problemText(one.code, one.arguments, one.text) };
});

test('a quoted problem is told in the language of the page', async () => {
  const { spoken } = await import('./spoken');
  const text = '`merker check` finds 2 errors; the first: main.awl:4: label M001 not found in this block';
  const quoted = { code: 'P0330', text: 'label M001 not found in this block', arguments: ['M001'] };
  const german = spoken({ effect: 'changed', text, quoted });
  expect(german).toContain('`merker check` findet 2 Fehler; zuerst: main.awl:4: ');
  expect(german).toContain('M001');
  expect(german).not.toContain('not found');
});
