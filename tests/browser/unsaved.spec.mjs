// Nothing typed is ever lost: reload, lost connection, another browser, another program on the disk.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { content, text, toLine } from './editor.mjs';
import { expect, open, picture, serve, until, visit } from './harness.mjs';

const server = await serve('06-first-program');
const file = join(server.project, 'first.awl');
const saved = () => readFileSync(file, 'utf-8');
const page = await open(server, 'program?file=first.awl');
const other = await open(server, 'program?file=first.awl', { language: 'en' });
const has = (which, words) => until(async () => (await text(which)).includes(words), words);
async function type(which, words) {
  await toLine(which, 1);
  await which.keyboard.insertText(`${words}\n`);
  await has(which, words);
}

test('what one browser saves, the other shows', async () => {
  await type(page, '// from the first');
  await page.keyboard.press('Control+s');
  await has(other, '// from the first');
});

test('unsaved text comes back after a reload', async () => {
  await type(page, '// not saved');
  await page.reload();
  await has(page, '// not saved');
  await page.getByText('nicht gespeichert').first().waitFor({ state: 'attached' });
  assert.ok(!saved().includes('// not saved'));
});

test('both texts are kept when two browsers change the same file', async () => {
  await type(other, '// from the other');
  await other.keyboard.press('Control+s');
  await page.getByText(/wurde anderswo geändert/).waitFor();
  await has(page, '// not saved');
  await page.getByRole('button', { name: 'Unterschied zeigen' }).click();
  await page.locator('#program-panel .cm-changedLine').first().waitFor();
  await picture(page, 'program-conflict');
  await page.getByRole('button', { name: 'Meinen Text behalten' }).click();
  await expect(() => page.getByText(/wurde anderswo geändert/).count(), 0);
  await has(page, '// not saved');
  assert.ok(saved().includes('// from the other'));
});

test('the other text is taken, and undo brings ours back', async () => {
  writeFileSync(file, `// from the disk\n${saved()}`);
  await page.getByText(/wurde anderswo geändert/).waitFor();
  await page.getByRole('button', { name: 'Anderen Text übernehmen' }).click();
  await has(page, '// from the disk');
  await page.locator('.code .cm-content').focus();
  await page.keyboard.press('Control+z');
  await has(page, '// not saved');
});

test('what is in sight stays when somebody else changes the text above it and below', async () => {
  const own = await serve('sorting-plant');
  const reader = await open(own, 'program?file=sorting.awl');
  const path = join(own.project, 'sorting.awl');
  const lines = readFileSync(path, 'utf-8').split('\n');
  const middle = Math.round(lines.length / 2);
  await until(async () => (await text(reader)) === lines.join('\n'), 'the text');
  await toLine(reader, middle);
  const firstInSight = () =>
    content(reader).evaluate((element) => {
      const { view } = element.cmTile.root;
      const { left, top } = view.scrollDOM.getBoundingClientRect();
      const { from } = view.state.doc.lineAt(view.posAtCoords({ x: left + 200, y: top + 12 }, false));
      return view.state.sliceDoc(from, from + 200);
    });
  const before = await firstInSight();
  writeFileSync(path, ['// above', ...lines, '// below'].join('\n'));
  await has(reader, '// below');
  await reader.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.equal(await firstInSight(), before);
});

test('two tabs of one browser: what the one saves costs the other nothing', async () => {
  const own = await serve('06-first-program');
  const first = await open(own, 'program?file=first.awl');
  const second = await first.context().newPage();
  await visit(second, own, 'program?file=first.awl');
  await second.locator('.code .cm-content').waitFor();
  await type(first, '// of the first tab');
  await type(second, '// of the second tab');
  await second.keyboard.press('Control+s');
  await first.getByText(/wurde anderswo geändert/).waitFor();
  await first.reload();
  await has(first, '// of the first tab');
  await first.getByText(/wurde anderswo geändert/).waitFor();
});
