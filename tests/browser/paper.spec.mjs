// Sources, data blocks, symbols, hardware, variable tables, diagnosis, reference data on paper: all of it, and nothing of the page around it (S7-EDIT-22).
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { expect, open, serve, turn, until, visit, write } from './harness.mjs';

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
  for (const view of ['program?file=sorting.awl', 'symbols', 'hardware', 'variables', 'diagnosis', 'diagnosis?page=information']) {
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
  const modules = await printed(/4\s+SM 321[^]*E 0\.0…1\.7/);
  // What is set on the CPU and on channels, as HW Konfig prints it.
  assert.match(modules, /MPI-Adresse: \d[^]*Zyklusüberwachungszeit: 150ms[^]*Remanente Merkerbytes: 16[^]*Kanal E 0: Messbereich:/);
  assert.doesNotMatch(modules, /Steckplatz: |Typ: |Passwort/);
  assert.match(modules, /Arbeitsspeicher: \d+ Byte[^]*Eingangsverzögerung: 3ms/);
  assert.doesNotMatch(modules, /work memory|timers|order number|slot:|input delay/);
});

/** Presses the button, and gives what would be on paper. */
async function pressed(button, words) {
  await page.evaluate(() => (window.print = () => (document.body.dataset.printed = 'yes')));
  await button.press('Enter');
  await page.locator('body[data-printed]').waitFor();
  await page.evaluate(() => delete document.body.dataset.printed);
  return printed(words);
}

test('a variable table with all of its rows and their values, also those out of sight', async () => {
  const rows = Array.from({ length: 150 }, (_, index) => `MB ${index + 50} ; UDEC ; ${index === 149 ? 7 : ''}`);
  writeFileSync(join(server.project, 'long.vat'), ['// of the press', ...rows, '"Light barrier small"', 'MB 70000', ''].join('\n'));
  await visit(page, server, 'variables');
  await turn(page, 'RUN-P');
  await write(page, { 'MB 199': 77 });
  await until(async () => (await page.locator('#variable-table option').allInnerTexts()).includes('long.vat'), 'the file');
  await page.locator('#variable-table').selectOption('long.vat');
  await page.locator('tr[data-operand="MB 50"]').waitFor();
  assert.equal(await page.locator('tr[data-operand="MB 199"]').count(), 0, 'it is out of sight');
  const text = await pressed(page.getByRole('button', { name: 'Drucken …' }), /MB 199\s+UDEC\s+77\s+7/);
  assert.match(text, /^Variablentabelle: long\.vat, Sorting plant\n[^]*\/\/ of the press\n/);
  assert.match(text, /"Light barrier small"\s+E 0\.\d\s+AUTO\s+(0|1|TRUE|FALSE)/i);
  assert.match(text, /MB 70000\s+\S+[^\n]*\?/);
  assert.equal(text.match(/^MB /gm).length, 151);
  await page.locator('tr[data-operand="MB 50"] input').first().focus();
  await page.keyboard.press('Control+p');
  await page.locator('body[data-printed]').waitFor();
  await printed(/MB 199\s+UDEC\s+77/);
});

test('the diagnostic buffer and the module information', async () => {
  await turn(page, 'STOP');
  await turn(page, 'RUN-P');
  await visit(page, server, 'diagnosis');
  const rows = page.getByRole('table').locator('tbody tr');
  await until(async () => (await rows.count()) > 3, 'entries');
  const count = await rows.count();
  const buffer = await pressed(page.getByRole('button', { name: 'Drucken …' }), /16#[0-9A-F]{4}\s+[^]*STOP/);
  assert.match(buffer, /^Diagnosepuffer, Sorting plant, CPU 314C-2 PtP\n/);
  assert.equal(buffer.match(/16#[0-9A-F]{4}\s/g).length, count);
  await page.getByRole('tab', { name: 'Baugruppenzustand' }).click();
  await page.getByRole('tabpanel').getByText('314C-2 PtP').first().waitFor();
  const module = await pressed(page.getByRole('button', { name: 'Drucken …' }), /Arbeitsspeicher/);
  assert.match(module, /^Baugruppenzustand, Sorting plant\n/);
});

test('reference data are papers of their own, beside the text or the drawing', async () => {
  await visit(page, server, 'program?file=sorting.awl');
  await page.getByRole('tab', { name: 'Referenzdaten' }).click();
  const button = page.locator('#program-panel').getByRole('button', { name: 'Drucken …' });
  const choose = (name) => page.locator('#program-panel').getByRole('tab', { name }).click();
  await until(async () => Number((await page.locator('#program-panel [role=status]').innerText()).match(/^\d+/)?.[0]) > 30, 'uses');
  const uses = Number((await page.locator('#program-panel [role=status]').innerText()).match(/^\d+/)[0]);
  const cross = await pressed(button, /sorting\.awl:\d+/);
  assert.match(cross, /^Querverweisliste: Sorting plant\n/);
  assert.equal(cross.match(/sorting\.awl:\d+/g).length, uses);
  assert.doesNotMatch(cross, /END_ORGANIZATION_BLOCK/);
  await choose('Belegungsplan');
  await page.locator('[data-byte]').first().waitFor();
  assert.match(await pressed(button, /^EB 0\s/m), /^Belegungsplan: Sorting plant\n[^]*Zeiten: [^]*Zähler: /);
  await choose('Programmstruktur');
  assert.match(await pressed(button, /^FB 2, DB 11\s/m), /^Programmstruktur: Sorting plant\n[^]*^OB 1\s/m);
  await choose('Nicht verwendete Symbole');
  assert.match(await pressed(button, /Operanden ohne Symbol/), /^Nicht verwendete Symbole: Sorting plant\n/);
  // The command of the browser prints the text, and then the drawing, whatever the drawer has.
  assert.doesNotMatch(await printed(/END_FUNCTION_BLOCK/), /Operanden ohne Symbol/);
  await page.getByRole('treeitem', { name: /^FC 1\b/ }).click();
  await page.getByRole('button', { name: 'KOP', exact: true }).click();
  await page.locator('.networks [data-network]').first().waitFor();
  await page.evaluate(() => (window.print = () => {}));
  await button.press('Enter');
  await page.emulateMedia({ media: 'print' });
  await until(async () => (await paper.innerText()).includes('Operanden ohne Symbol'), 'the paper');
  assert.equal(await page.locator('.networks').isVisible(), false, 'the drawing');
  await page.emulateMedia({ media: null });
  await expect(() => paper.count(), 0, 'printing is over');
  await page.emulateMedia({ media: 'print' });
  await expect(() => page.locator('.networks').isVisible(), true, 'the drawing');
  assert.equal(await paper.count(), 0);
  await page.emulateMedia({ media: null });
  await page.getByRole('button', { name: 'AWL', exact: true }).click();
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
