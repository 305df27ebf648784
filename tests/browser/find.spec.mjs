// Finding: one search over the whole project with replacing, and the reference data (S7-EDIT-22).
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { text, toLine } from './editor.mjs';
import { expect, message, open, serve, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'io');
const panel = page.locator('#program-panel');
const field = panel.getByLabel('Text, auch ein Teil eines Wortes');
const found = () => panel.locator('.count').innerText();
const hits = panel.locator('tr[data-hit]');
const roomy = async () => {
  let crowded;
  await until(async () => (crowded = await crowding(page)).length === 0, () => crowded.join('\n'));
};
const reference = async (name) => page.getByRole('tab', { name }).click();

test('Ctrl Shift F looks for a part of a word in all files, from any view', async () => {
  await page.keyboard.press('Control+Shift+F');
  await until(() => field.evaluate((one) => one.getRootNode().activeElement === one), 'the focus');
  await page.keyboard.type('lider sm');
  await until(async () => /^[1-9]\d* Stellen in \d+ Dateien, 0 Bausteine/.test(await found()), 'places');
  const files = await hits.locator('button').allInnerTexts();
  for (const file of ['sorting.awl', 'sorting.sym', 'sizes.scn']) assert.ok(files.some((one) => one.startsWith(file)), `${file} in ${files}`);
  assert.match(await hits.first().locator('mark').innerText(), /^lider sm$/i);
  await roomy();
  await accessible(page, 'search');
});

test('blocks and comments are found; a place opens', async () => {
  await field.fill('classif');
  await until(async () => /, [1-9]\d* Bausteine/.test(await found()), 'blocks');
  await panel.getByRole('button', { name: 'FB 1' }).waitFor();
  await field.fill('boxes pushed since');
  await expect(() => hits.count(), 1);
  await expect(found, '1 Stelle in 1 Datei, 0 Bausteine');
  await hits.getByRole('button').press('Enter');
  await until(async () => (await page.locator('.code .cm-activeLine').innerText()).includes('boxes pushed'), 'the line');
  await field.fill('KLEIN UND GROSS IST GLEICH');
  await panel.getByText('Nichts gefunden.').waitFor();
});

test('what is replaced is seen before, left out where one wants, and saved at once', async () => {
  await field.fill('TravelSmall');
  await panel.getByLabel('Ganzes Wort').check();
  await until(async () => (await hits.count()) >= 2, 'places');
  const all = await hits.count();
  await panel.getByLabel('Ersetzen durch').fill('WaySmall');
  await panel.getByLabel('Vorschau').check();
  await expect(() => hits.first().locator('ins').innerText(), 'WaySmall');
  await hits.last().getByRole('checkbox').uncheck();
  await accessible(page, 'replace');
  const kept = (await hits.last().locator('button').innerText()).split(':');
  await panel.getByRole('button', { name: `${all - 1} ersetzen` }).press('Enter');
  await panel.getByText(new RegExp(`^${all - 1} Stellen in \\d Dateien ersetzt. Noch nicht gespeichert.`)).waitFor();
  await expect(() => hits.count(), 1);
  assert.match(await text(page), /WaySmall +: S5TIME/);
  await panel.getByRole('button', { name: /Dateien speichern$/ }).press('Enter');
  await until(() => readFileSync(join(server.project, 'sorting.awl'), 'utf-8').includes('WaySmall'), 'the file');
  assert.ok(readFileSync(join(server.project, kept[0]), 'utf-8').split('\n')[kept[1] - 1].includes('TravelSmall'), 'what was left out stays');
  // As it was: the program is to be compiled again.
  await panel.getByLabel('Vorschau').uncheck();
  await field.fill('WaySmall');
  await panel.getByLabel('Ersetzen durch').fill('TravelSmall');
  await panel.getByLabel('Vorschau').check();
  await until(async () => (await hits.count()) === all - 1, 'the new name');
  await panel.getByRole('button', { name: `${all - 1} ersetzen` }).click();
  await panel.getByRole('button', { name: /Dateien speichern$/ }).click();
  await until(() => !readFileSync(join(server.project, 'sorting.awl'), 'utf-8').includes('WaySmall'), 'the old name');
});

test('one click takes a replacement back in all files', async () => {
  const before = await text(page);
  await panel.getByLabel('Ersetzen durch').fill('Gone');
  await field.fill('Slider small');
  // Of these words, not of those that were looked for before.
  await until(async () => /slider small/i.test(await hits.first().innerText()), 'places of the new words');
  await until(async () => new Set((await hits.locator('button').allInnerTexts()).map((one) => one.split(':')[0])).size >= 3, 'several files');
  await panel.getByRole('button', { name: /^\d+ ersetzen$/ }).click();
  await expect(() => page.locator('.dirty').count(), 3);
  await accessible(page, 'replaced');
  await panel.getByRole('button', { name: 'Rückgängig' }).press('Enter');
  await message(page, /3 Dateien wie vor dem Ersetzen/);
  await expect(() => page.locator('.dirty').count(), 0);
  assert.equal(await text(page), before);
  await expect(() => panel.getByRole('button', { name: 'Rückgängig' }).count(), 0);
});

test('other words are replaced only where they stand', async () => {
  await field.fill('Slider small');
  await panel.getByRole('button', { name: /^[1-9]\d* ersetzen$/ }).and(panel.locator(':enabled')).waitFor();
  // Before the page looks for them; a click then waits for it.
  const enabled = await field.evaluate(async (input) => {
    input.value = 'Slider middle';
    input.dispatchEvent(new Event('input', { bubbles: true }));
    await Promise.resolve();
    return [...input.closest('.bar').querySelectorAll('button')].some((one) => / ersetzen$/.test(one.textContent) && !one.disabled);
  });
  assert.equal(enabled, false, 'the places of the former words are still those to be replaced');
  await panel.getByRole('button', { name: /^\d+ ersetzen$/ }).click();
  await panel.getByText(/^[1-9]\d* Stellen in \d Dateien ersetzt/).waitFor();
  await panel.getByRole('button', { name: 'Rückgängig' }).click();
  await expect(() => page.locator('.dirty').count(), 0);
});

test('what is written about the project is replaced only if one says so', async () => {
  await field.fill('Slider small');
  const ticks = (file) => panel.locator(`tr[data-hit^="${file}"]`).getByRole('checkbox');
  await until(async () => (await ticks('README.md').count()) > 0 && (await ticks('sorting.awl').count()) > 0, 'hits of both');
  assert.equal(await ticks('README.md').first().isChecked(), false);
  assert.equal(await ticks('sorting.awl').first().isChecked(), true);
});

test('after a reload the dots and the problems are those of all drafts', async () => {
  await panel.getByLabel('Groß/klein').check();
  await field.fill('Slider small');
  const symbols = panel.locator('tr[data-hit^="sorting.sym"]').getByRole('checkbox');
  await expect(() => symbols.count(), 1);
  await symbols.uncheck();
  await panel.getByRole('button', { name: /^\d+ ersetzen$/ }).click();
  await expect(() => page.locator('.dirty').count(), 2);
  await visit(page, server, 'program?file=sizes.scn');
  await page.reload();
  await expect(() => page.locator('.dirty').count(), 2);
  await page.getByRole('tab', { name: /^Fehler/ }).click();
  await panel.getByText(/^sorting\.awl/).first().waitFor();
  await page.keyboard.press('Control+Shift+F');
  await field.fill('Gone');
  await panel.getByLabel('Ersetzen durch').fill('Slider small');
  await panel.getByLabel('Vorschau').check();
  await panel.getByRole('button', { name: /^\d+ ersetzen$/ }).click();
  await expect(() => page.locator('.dirty').count(), 0);
  await visit(page, server, 'program?file=sorting.awl');
});

test('a replacement is taken back after a reload', async () => {
  const before = await text(page);
  await page.keyboard.press('Control+Shift+F');
  await field.fill('Slider small');
  await panel.getByLabel('Ersetzen durch').fill('Gone');
  await panel.getByLabel('Vorschau').check();
  await panel.getByRole('button', { name: /^[1-9]\d* ersetzen$/ }).click();
  await until(async () => (await text(page)) !== before, 'the other words');
  const dirty = await page.locator('.dirty').count();
  await page.reload();
  await expect(() => page.locator('.dirty').count(), dirty);
  await page.keyboard.press('Control+Shift+F');
  await panel.getByRole('button', { name: 'Rückgängig' }).click();
  await expect(() => page.locator('.dirty').count(), 0);
  assert.equal(await text(page), before);
});

test('the values of the operands follow the cursor, and are modified beside the program', async () => {
  const watched = () => panel.locator('tr[data-nearby]').evaluateAll((rows) => rows.map((one) => one.dataset.nearby).join(' '));
  const lineOf = async (words) => (await text(page)).split('\n').findIndex((one) => one.includes(words)) + 1;
  await page.getByRole('tab', { name: 'Beobachten' }).click();
  await toLine(page, await lineOf(':= "Light barrier small"'));
  await until(async () => (await watched()).includes('"Light barrier small"'), 'the operands of the network');
  const barrier = panel.locator(`tr[data-nearby='"Light barrier small"']`);
  await expect(() => barrier.locator('.value.number').innerText(), '1');
  await accessible(page, 'values beside the program');
  const before = await watched();
  await panel.getByRole('switch').press('Space');
  await toLine(page, await lineOf('FUNCTION_BLOCK "Slider"') + 40);
  await expect(() => page.locator('.code .cm-lineNumbers .cm-activeLineGutter').count(), 1);
  assert.equal(await watched(), before);
  await panel.getByRole('switch').press('Space');
  await until(async () => (await watched()) !== before, 'the operands of this network');
});

test('the cross reference finds a part of a symbol', async () => {
  await reference('Referenzdaten');
  const operand = panel.getByLabel('Operand oder Symbol');
  await operand.fill('slider');
  const rows = panel.locator('tbody tr');
  await until(async () => (await rows.count()) > 3 && /slider/i.test(await rows.first().innerText()), 'rows');
  // An operand means what it touches, as before.
  await operand.fill('AB 1');
  await until(async () => /^A 1\.0/.test(await rows.first().innerText()), 'its bits');
});

test('assignment list, program structure, unused symbols', async () => {
  await reference('Belegungsplan');
  const byte = panel.locator('tr[data-byte="AB 1"]');
  await until(async () => /AB 1[^×]*×\s*×\s*×/.test(await byte.innerText()), 'bits 2 to 0');
  await accessible(page, 'assignment list');
  await byte.getByRole('button').press('Enter');
  await expect(() => panel.getByLabel('Operand oder Symbol').inputValue(), 'AB 1');
  await reference('Programmstruktur');
  const structure = panel.getByRole('table', { name: 'Programmstruktur' });
  const body = structure.locator('tbody');
  await until(async () => /^\s*OB 1\b[^]*FB 1, DB \d/.test(await body.innerText()), 'the calls of OB 1 with their instances');
  await structure.locator('th', { hasText: 'im Pfad' }).waitFor();
  await until(async () => /^\s*OB 1\b[^\n]*höchstens \d\d+ Byte im Pfad/.test(await body.innerText()), 'the longest path');
  await accessible(page, 'program structure');
  await reference('Nicht verwendete Symbole');
  await panel.getByRole('table', { name: 'Nicht verwendete Symbole' }).waitFor();
  await panel.getByRole('table', { name: 'Operanden ohne Symbol' }).waitFor();
  await accessible(page, 'unused');
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await roomy();
  }
});

test('the program structure says which block is missing, and opens a data block', async () => {
  const source = 'FUNCTION FC 90 : VOID\nBEGIN\nNETWORK\n L DB90.DBW 0;\n UC FC 91;\nEND_FUNCTION\n';
  const data = 'DATA_BLOCK DB 90\nSTRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n';
  writeFileSync(join(server.project, 'missing.awl'), source + data);
  await reference('Programmstruktur');
  const row = (id) => panel.getByRole('table', { name: 'Programmstruktur' }).locator('tr', { hasText: id });
  await until(async () => /fehlt/.test(await row('FC 91').innerText()), 'what is missing');
  assert.doesNotMatch(await row('DB 90').innerText(), /fehlt/);
  await row('DB 90').getByRole('button').press('Enter');
  await until(async () => (await page.locator('.code .cm-activeLine').innerText()).includes('DATA_BLOCK DB 90'), 'its source');
});

test('the assignment list of an English page asks in English, also of a program of STEP 5', async () => {
  for (const project of [server, await serve('step5/tool-changer')]) {
    const english = await open(project, 'program', { language: 'en' });
    const operand = english.getByLabel('Operand or symbol');
    const first = english.locator('#program-panel tbody tr').first();
    await english.getByRole('tab', { name: 'Reference data' }).click();
    await english.getByRole('tab', { name: 'Assignment list' }).click();
    await english.locator('tr[data-byte="AB 1"]').getByRole('button').click();
    await expect(() => operand.inputValue(), 'QB 1');
    await until(async () => /^QW? \d/.test(await first.innerText()), 'the bits of the byte');
    await operand.fill('E 0.0');
    await until(async () => /^I 0\.0/.test(await first.innerText()), 'what German letters mean');
    await operand.fill('Q 1');
    await until(async () => /^QW? \d/.test(await first.innerText()), 'a part of an operand');
    await english.getByRole('tab', { name: 'Program structure' }).click();
    await english.locator('#program-panel tbody').getByRole('button', { name: 'OB 1', exact: true }).waitFor();
    // STEP 5 has no local data.
    const local = english.locator('#program-panel th', { hasText: /Local data|In the path/ });
    await expect(() => local.count(), project === server ? 2 : 0);
  }
});

test('what stands beside a German text has its words, on an English page as well', async () => {
  const lines = readFileSync(join(server.project, 'sorting.awl'), 'utf-8').split('\n');
  const line = lines.findIndex((one) => one.includes(':= "Light barrier small"')) + 1;
  const english = await open(server, `program?file=sorting.awl&line=${line}`, { language: 'en' });
  await english.getByRole('tab', { name: 'Monitor' }).click();
  const address = english.locator(`tr[data-nearby='"Light barrier small"'] td`).nth(1);
  await expect(() => address.innerText(), 'E 0.0');
  // The same text in international mnemonics.
  await english.getByLabel('Mnemonics').selectOption('international');
  await expect(() => address.innerText(), 'I 0.0');
});
