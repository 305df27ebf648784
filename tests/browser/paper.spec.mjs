// Sources, data blocks, symbols and hardware on paper: all of it, and nothing of the page around it (S7-EDIT-22).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { expect, open, serve, until, visit } from './harness.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'program?file=sorting.awl');
const paper = page.locator('.on-paper');

/** What is on paper, until it says that. */
async function printed(words) {
  await page.emulateMedia({ media: 'print' });
  let text;
  await until(async () => words.test((text = await paper.innerText())), () => `${words} in ${text}`);
  for (const hidden of ['header', 'footer', 'main h1:not(.on-paper h1)']) await expect(() => page.locator(hidden).first().isVisible(), false, hidden);
  assert.ok((await page.pdf()).length > 1000);
  await page.emulateMedia({ media: null });
  await expect(() => paper.count(), 0, 'papers on the screen');
  return text;
}

test('each view that has something for paper has a button for it', async () => {
  for (const view of ['program?file=sorting.awl', 'symbols', 'hardware']) {
    await visit(page, server, view);
    const button = page.getByRole('button', { name: 'Drucken …' });
    await button.waitFor();
    await page.evaluate(() => (window.print = () => (document.title = 'printed')));
    await button.press('Enter');
    await expect(() => page.title(), 'printed', view);
    await page.reload();
    await page.locator('[data-phase="open"]').waitFor();
  }
  await visit(page, server, 'program?file=sorting.awl');
});

test('a source from its first line to its last', async () => {
  await page.locator('.code .cm-content').waitFor();
  const source = readFileSync(join(server.project, 'sorting.awl'), 'utf-8');
  const text = await printed(/END_ORGANIZATION_BLOCK/);
  for (const line of source.split('\n').filter((one) => one.trim())) assert.ok(text.includes(line.trim()), line);
});

test('of a source with several blocks, the one that is chosen', async () => {
  await page.getByRole('treeitem', { name: /^FB 2\b/ }).click();
  await until(async () => (await page.locator('.code .cm-activeLine').innerText()).startsWith('FUNCTION_BLOCK "Slider"'), 'FB 2');
  const text = await printed(/END_FUNCTION_BLOCK/);
  assert.match(text, /^sorting\.awl: "Slider"/);
  assert.doesNotMatch(text, /ORGANIZATION_BLOCK|"Classify box"/);
});

test('a data block with its values, the symbols, the modules', async () => {
  await visit(page, server, 'program?block=DB%2020');
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await page.locator('.data tr[data-path]').first().waitFor();
  await printed(/^Daten von DB 20[^]*Name/m);
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await visit(page, server, 'symbols');
  await page.locator('.table tbody tr').first().waitFor();
  const symbols = readFileSync(join(server.project, 'sorting.sym'), 'utf-8').match(/^"[^"]+"/gm);
  const text = await printed(/Light barrier small/);
  for (const name of symbols) assert.ok(text.includes(name.slice(1, -1)), name);
  await visit(page, server, 'hardware');
  await page.getByRole('button', { name: /SM 321/ }).waitFor();
  const modules = await printed(/0\/4\s+[^]*E 0\.0…1\.7/);
  assert.match(modules, /Arbeitsspeicher: \d+ Byte[^]*Eingangsverzögerung: 3ms/);
  assert.doesNotMatch(modules, /work memory|timers|order number|slot:|input delay/);
});

test('paper is white and its letters are dark, whatever the theme', async () => {
  const dark = await open(server, 'program?file=sorting.awl', { theme: 'dark' });
  await dark.locator('.code .cm-content').waitFor();
  const colours = () => dark.evaluate(() => {
    const { colorScheme } = getComputedStyle(document.documentElement);
    const { color } = getComputedStyle(document.querySelector('.on-paper') ?? document.body);
    return [colorScheme, color, ...['--raised', '--code-operand', '--warning-soft'].map((name) => getComputedStyle(document.documentElement).getPropertyValue(name))].join(' ');
  });
  assert.match(await colours(), /^dark/);
  await dark.emulateMedia({ media: 'print' });
  await expect(colours, 'light rgb(0, 0, 0) #fff #000 #fbeac6');
  await dark.emulateMedia({ media: null });
  await expect(async () => (await colours()).slice(0, 4), 'dark');
});
