import { beforeEach, expect, test } from 'vitest';
import { OpenDocument } from './document.svelte';
import { Drafts } from './drafts';

const storageOf = (kept: Map<string, string>) => ({
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => void kept.set(key, value),
  removeItem: (key: string) => void kept.delete(key),
  get length() {
    return kept.size;
  },
  key: (index: number) => [...kept.keys()][index] ?? null,
});
const kept = new Map<string, string>();
const storage = storageOf(kept);
const drafts = new Drafts(storage, 'plant');
const opened = (text = 'U E 0.0', revision = 1) => new OpenDocument('a.awl', { text, revision }, drafts);
beforeEach(() => kept.clear());

test('what was typed comes back after a reload', () => {
  opened().edit('U E 0.1');
  expect(opened().text).toBe('U E 0.1');
  expect(opened().dirty).toBe(true);
  expect(opened().conflict).toBeNull();
});

test('a saved text is no draft any more, what was typed meanwhile is', () => {
  const document = opened();
  document.edit('U E 0.1');
  document.edit('U E 0.12');
  document.saved('U E 0.1', 2);
  expect(document.dirty).toBe(true);
  document.saved('U E 0.12', 3);
  expect(kept.size).toBe(0);
});

test('without own changes the text follows the other browser', () => {
  const document = opened();
  document.arrived({ text: 'O M 1.0', revision: 2 });
  expect(document.text).toBe('O M 1.0');
  expect(document.revision).toBe(2);
});

test('with own changes nothing is lost: both texts are there until the user decides', () => {
  const document = opened();
  document.edit('mine');
  document.arrived({ text: 'theirs', revision: 2 });
  expect(document.text).toBe('mine');
  expect(document.conflict).toEqual({ text: 'theirs', revision: 2 });
  document.keepMine();
  expect([document.text, document.revision, document.dirty]).toEqual(['mine', 2, true]);
  document.arrived({ text: 'theirs again', revision: 3 });
  document.takeTheirs();
  expect([document.text, document.dirty, document.conflict]).toEqual(['theirs again', false, null]);
});

test('a draft of an older text is a conflict after a reload', () => {
  opened().edit('mine');
  expect(opened('theirs', 2).conflict).toEqual({ text: 'theirs', revision: 2 });
  expect(opened('theirs', 2).text).toBe('mine');
  expect(opened('mine', 2).conflict).toBeNull();
});

test('another project of the same file names has its own drafts', () => {
  opened().edit('mine');
  expect(new Drafts(storage, 'other').read('a.awl')).toBeNull();
});

test('each tab keeps what was typed in it, whatever another one types or saves', () => {
  const tab = (): Drafts => new Drafts(storage, 'plant', storageOf(new Map()));
  const here = tab();
  const there = tab();
  const stored = { text: 'U E 0.0', revision: 1 };
  new OpenDocument('a.awl', stored, here).edit('U E 0.1');
  const other = new OpenDocument('a.awl', stored, there);
  other.edit('U E 0.2');
  expect(new OpenDocument('a.awl', stored, here).text).toBe('U E 0.1');
  other.saved('U E 0.2', 2);
  const again = new OpenDocument('a.awl', { text: 'U E 0.2', revision: 2 }, here);
  expect(again.text).toBe('U E 0.1');
  expect(again.conflict?.text).toBe('U E 0.2');
  expect(kept.size).toBe(0);
});

test('the files with drafts are known without opening them', () => {
  opened().edit('U E 0.1');
  new Drafts(storage, 'plant 2').write('b.awl', { text: 'U E 0.2', revision: 1 });
  expect(drafts.paths()).toEqual(['a.awl']);
  expect(new Drafts(storage, 'pla').paths()).toEqual([]);
});
