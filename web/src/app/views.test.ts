import { expect, test } from 'vitest';
import { help } from '../i18n/help';
import { views } from './views';

test('F1 says of each view how its work is done, in both languages', () => {
  expect(Object.keys(help).sort()).toEqual(views.map((view) => view.id).sort());
  for (const [german, english] of Object.values(help).flat()) {
    expect(german).toMatch(/\.$/);
    expect(english).toMatch(/\.$/);
    expect(german).not.toBe(english);
  }
});
