// The whole page by keyboard alone: no pointer is used here.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { bit, expect, leave, message, open, quiet, serve, until } from './harness.mjs';

const server = await serve('06-first-program');
const page = await open(server, 'projects');
const here = () => page.evaluate(() => document.activeElement?.getAttribute('aria-label') || document.activeElement?.innerText || document.activeElement?.id || '');
const view = () => page.evaluate(() => location.hash.replace(/^#\/?([a-z]*).*/, '$1'));

/** Tab until the focus is on what is wanted. */
async function tabTo(wanted, most = 150) {
  const seen = [];
  for (let count = 0; count < most; count++) {
    // In the text Tab indents; Esc before it leaves.
    if (await page.evaluate(() => Boolean(document.activeElement?.shadowRoot ?? document.activeElement?.closest('.cm-editor'))))
      await page.keyboard.press('Escape');
    await page.keyboard.press('Tab');
    const now = (await here()).trim();
    seen.push(now);
    if (wanted.test(now)) return;
  }
  assert.fail(`never reached ${wanted}; there were ${[...new Set(seen)].join(' | ')}`);
}

test('each view is reached by Tab and Enter', async () => {
  for (const [name, id] of [['Hardware', 'hardware'], ['Symbole', 'symbols'], ['Programm', 'program'], ['E/A', 'io'], ['Variablen', 'variables'], ['Anlage', 'process'], ['Kurven', 'trends'], ['Diagnose', 'diagnosis'], ['Projekt', 'projects']]) {
    await tabTo(new RegExp(`^${name}$`));
    await page.keyboard.press('Enter');
    await expect(view, id);
    await page.locator('main h1').first().waitFor();
  }
});

test('what has the focus is seen', async () => {
  await page.keyboard.press('Tab');
  const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
  assert.notEqual(outline, 'none');
});

test('a module is configured without a pointer (S7-HWCFG-01)', async () => {
  await page.reload();
  await tabTo(/^Hardware$/);
  await page.keyboard.press('Enter');
  await tabTo(/^Im Betrieb$/);
  await page.keyboard.press('ArrowRight');
  await page.locator('tr[data-slot="4"]').waitFor();
  await tabTo(/Katalog filtern/);
  await page.keyboard.type('321-1BH02');
  await tabTo(/SM 321 DI16xDC24V/);
  await page.keyboard.press('Enter');
  await tabTo(/^Steckplatz 4: frei$/);
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Steckplatz 4: SM 321 DI16xDC24V' }).waitFor();
  await tabTo(/^Rückgängig$/);
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Steckplatz 4: frei' }).waitFor();
});

test('an input is switched, a dialog opened and left, without a pointer', async () => {
  await tabTo(/^E\/A$/);
  await page.keyboard.press('Enter');
  await page.locator('button[data-operand="E 0.0"]').first().waitFor();
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute('data-operand'));
  for (let count = 0; count < 150 && (await focused()) !== 'E 0.0'; count++) await page.keyboard.press('Tab');
  assert.equal(await focused(), 'E 0.0');
  await page.keyboard.press('Space');
  await expect(() => bit(page, 'E 0.0'), '1');
  await page.keyboard.press('F1');
  await page.getByRole('dialog').waitFor();
  await leave(page);
});

test('the mode selector follows the arrow keys', async () => {
  await tabTo(/^(RUN-P|RUN|STOP)$/);
  for (let count = 0; count < 4 && !/STOP/.test(await here()); count++) await page.keyboard.press('ArrowDown');
  if (/STOP/.test(await here())) await page.keyboard.press('Enter');
  await until(() => page.locator('[data-mode="STOP"]').count(), 'STOP');
});

const row = () => page.evaluate(() => Number(document.activeElement?.closest('tr')?.dataset.row ?? -1));
const type = async (text) => (await page.keyboard.type(text), await page.keyboard.press('Enter'));

test('a table of variables is filled and walked by keys', async () => {
  await tabTo(/^Variablen$/);
  await page.keyboard.press('Enter');
  await tabTo(/^Operand .*1$/);
  await type('MW 100..106');
  await expect(row, 4, 'the empty row below the range');
  await type('MW 200');
  await expect(row, 5);
  await page.keyboard.press('ArrowUp');
  await expect(row, 4);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Control+Home');
  await expect(row, 0);
  await type('MW 300..698');
  await page.keyboard.press('Control+Home');
  await expect(row, 0);
  await page.keyboard.press('Control+End');
  await expect(async () => (await row()) > 200, true, 'the last row, which was not there');
  await page.keyboard.press('Control+Home');
  await expect(row, 0);
  // The field of the modify value has the same keys.
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowDown');
  await expect(row, 1);
  assert.match(await here(), /^Steuerwert/);
});

const pane = () => page.evaluate(() => {
  const at = (selector) => document.activeElement?.closest(selector);
  return at('.messages') ? 'messages' : at('.side') ? 'list' : at('[role=toolbar]') ? 'bar' : at('.work > .text') ? 'text' : at('.panel') ? 'drawer' : '';
});

async function toPane(wanted) {
  for (let presses = 0; presses < 6 && (await pane()) !== wanted; presses++) await page.keyboard.press('F6');
  assert.equal(await pane(), wanted);
}

test('F6 goes round the panes of the program, Esc and Tab lead out of the text', async () => {
  await page.reload();
  await tabTo(/^Programm$/);
  await page.keyboard.press('Enter');
  await page.locator('.code .cm-content').waitFor();
  await page.getByRole('treeitem').first().waitFor();
  await expect(pane, 'text', 'the entry block is open');
  for (const wanted of ['drawer', 'list', 'bar', 'text', 'drawer']) {
    await page.keyboard.press('F6');
    await expect(pane, wanted);
  }
  for (const [key, wanted] of [['Shift+F6', 'text'], ['Shift+F6', 'bar'], ['F6', 'text']]) {
    await page.keyboard.press(key);
    await expect(pane, wanted);
  }
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await until(async () => (await pane()) !== 'text', 'out of the text');
});

test('the menu of the text gives the keyboard back to it', async () => {
  const inText = () => page.evaluate(() => document.querySelector('.code').shadowRoot.activeElement?.className.includes('cm-content') ?? false);
  await toPane('text');
  for (const leave of [['Escape'], ['Tab'], ['ArrowUp', 'Enter']]) {
    await page.keyboard.press('Control+j');
    await page.getByRole('menuitem').first().waitFor();
    for (const key of leave) await page.keyboard.press(key);
    await expect(inText, true, `after ${leave}`);
    await expect(() => page.getByRole('menuitem').count(), 0);
  }
  await page.keyboard.press('Control+j');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter'); // the breakpoint is off again
});

test('Ctrl S saves and Ctrl L loads from every pane of the program', async () => {
  const unsaved = page.getByText('nicht gespeichert').first();
  for (const [index, wanted] of ['drawer', 'list', 'bar'].entries()) {
    await toPane('text');
    await page.keyboard.press('Control+Home');
    await page.keyboard.insertText(`// ${index}\n`);
    await unsaved.waitFor({ state: 'attached' });
    await toPane(wanted);
    await page.keyboard.press('Control+s');
    await unsaved.waitFor({ state: 'detached' });
    assert.ok(readFileSync(join(server.project, 'first.awl'), 'utf-8').includes(`// ${index}\n`), `saved from the ${wanted}`);
    await quiet(page);
    await toPane(wanted);
    await page.keyboard.press('Control+l');
    await message(page, 'Programm geladen');
  }
});

test('the view gives way to a message of an error, which is closed by keys', async () => {
  const top = () => page.locator('.code').evaluate((code) => Math.round(code.getBoundingClientRect().top));
  await tabTo(/^(RUN-P|RUN|STOP)$/);
  for (let count = 0; count < 4 && (await here()).trim() !== 'RUN'; count++) await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await toPane('text');
  const before = await top();
  await page.keyboard.press('Control+l');
  const message = page.locator('.message.problem').first();
  await message.waitFor();
  assert.equal(await message.getAttribute('role'), 'alert');
  assert.equal(await top(), before, 'the text stays where it is');
  const end = await page.locator('main').evaluate((one) => one.getBoundingClientRect().bottom);
  assert.ok(end <= (await message.boundingBox()).y, 'nothing of the view is under it');
  await toPane('messages');
  for (let left = await page.locator('.message').count(); left > 0 && (await here()) !== 'Meldung schließen'; left--) await page.keyboard.press('Tab');
  const count = await page.locator('.message').count();
  await page.keyboard.press('Enter');
  await until(async () => (await page.locator('.message').count()) < count, 'one less');
  assert.notEqual(await here(), '', 'the keyboard is somewhere');
});
