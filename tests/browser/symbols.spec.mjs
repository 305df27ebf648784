// The symbol table with the rules of the course (S7-SYM, S7-MGR-11).
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, open, picture, quiet, scratch, serve, until, visit } from './harness.mjs';

const server = await serve('09-symbols');
const file = join(server.project, 'symbols.sym');
const saved = () => readFileSync(file, 'utf-8');
const page = await open(server, 'symbols');
const rows = page.locator('tbody tr');
const cell = (name, row) => page.getByLabel(`${name} ${row}`, { exact: true });
const save = page.getByRole('button', { name: 'Speichern', exact: true });
const problems = page.locator('.state li');

test('the table has symbol, operand, type and comment (S7-SYM-01, -02)', async () => {
  await expect(() => rows.count(), 8);
  await expect(() => cell('Symbol', 3).inputValue(), 'Motor');
  await expect(() => cell('Operand', 3).inputValue(), 'A 1.0');
  await expect(() => cell('Datentyp', 3).inputValue(), 'BOOL');
});

test('a new symbol is saved and known to the program (S7-SYM-04)', async () => {
  await page.getByRole('button', { name: '+ Zeile' }).click();
  await expect(() => cell('Symbol', 9).evaluate((one) => one === document.activeElement), true, 'the focus');
  await page.keyboard.type('Lamp');
  await cell('Operand', 9).fill('A 1.1');
  await cell('Operand', 9).press('Tab');
  await expect(() => cell('Datentyp', 9).inputValue(), 'BOOL', 'of the operand');
  await cell('Kommentar', 9).fill('on the door');
  await until(() => save.isEnabled(), 'a table without problems');
  await page.keyboard.press('Control+s');
  await until(() => /"Lamp"\s+A\s*1\.1\s+BOOL\s+\/\/ on the door/.test(saved()), 'the saved symbol');
});

const wrong = [
  ['a symbol twice (S7-SYM-03)', 'Symbol', 'Motor'],
  ['a symbol of 25 characters (S7-SYM-01)', 'Symbol', 'x'.repeat(25)],
  ['a comment of 81 characters (S7-SYM-01)', 'Kommentar', 'x'.repeat(81)],
  ['a name with a quotation mark', 'Symbol', 'Mo"tor', /P0809/],
  ['a name without its operand', 'Operand', '', /P0812/],
  ['a data word (S7-SYM-06)', 'Operand', 'DB100.DBW10'],
  ['local data (S7-SYM-15)', 'Operand', 'LW 2'],
  ['a type that does not fit (S7-SYM-16)', 'Datentyp', 'REAL'],
];
for (const [what, column, value, code = /P\d{4}/] of wrong)
  test(`${what}: the row is marked, nothing is saved, nothing is lost`, async () => {
    const before = saved();
    const old = await cell(column, 9).inputValue();
    await cell(column, 9).fill(value);
    await until(async () => code.test((await problems.first().innerText().catch(() => '')) ?? ''), 'a problem');
    await expect(() => rows.nth(8).evaluate((row) => row.classList.contains('wrong')), true);
    await expect(() => save.isEnabled(), false);
    await page.keyboard.press('Control+s');
    assert.equal(await cell(column, 9).inputValue(), value);
    if (column === 'Symbol' && value === 'Motor') await picture(page, 'symbols-twice');
    await page.reload();
    await expect(() => cell(column, 9).inputValue(), value, 'after a reload');
    assert.equal(saved(), before);
    await cell(column, 9).fill(old);
    await expect(() => problems.count(), 0);
  });

test('sort by a column and filter (S7-SYM-17)', async () => {
  await page.getByRole('button', { name: 'Operand', exact: false }).first().click();
  await expect(() => rows.first().getByLabel(/^Operand/).inputValue(), 'A 1.0');
  await page.getByRole('searchbox', { name: 'Filter' }).fill('minute');
  await expect(() => rows.count(), 2);
  await page.getByRole('searchbox', { name: 'Filter' }).fill('');
  await expect(() => rows.count(), 9);
});

test('export and import keep the table (S7-SYM-17)', async () => {
  const download = page.waitForEvent('download');
  await page.getByLabel('Exportieren').selectOption('sdf');
  const exported = join(scratch(), 'symbols.sdf');
  await (await download).saveAs(exported);
  const text = readFileSync(exported, 'utf-8');
  assert.match(text, /^"Motor\s+","A\s+1\.0\s+","BOOL\s+","/m);
  const one = join(scratch(), 'one.sdf');
  writeFileSync(one, text.split('\n').find((line) => line.startsWith('"Motor ')).replace('Motor ', 'Horn  ').replace(/1\.0/, '1.5') + '\n');
  await page.locator('input[type=file][accept]').setInputFiles(one);
  await expect(() => rows.count(), 10);
  await expect(() => cell('Symbol', 10).inputValue(), 'Horn');
});

test('a table of a spreadsheet is pasted: into the empty row, below a filled one', async () => {
  const paste = (name, row, text) => cell(name, row).evaluate((one, text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    one.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  }, text);
  const shown = async (row) => (await Promise.all(['Symbol', 'Operand', 'Datentyp', 'Kommentar'].map((name) => cell(name, row).inputValue()))).join('|');
  await page.getByRole('button', { name: '+ Zeile' }).click();
  await expect(() => rows.count(), 11);
  await paste('Symbol', 11, 'Neu Ä 1\tE 5.0\tBOOL\tKomm 1\nNeu Ä 2\tMW 50\tINT\tKomm 2\n');
  await expect(() => rows.count(), 12);
  await expect(() => shown(11), 'Neu Ä 1|E 5.0|BOOL|Komm 1');
  await expect(() => shown(12), 'Neu Ä 2|MW 50|INT|Komm 2');
  await paste('Operand', 11, 'Between\tE 5.1\tBOOL\tKomm 3\n');
  await expect(() => rows.count(), 13);
  await expect(() => shown(11), 'Neu Ä 1|E 5.0|BOOL|Komm 1');
  await expect(() => shown(12), 'Between|E 5.1|BOOL|Komm 3');
  await until(() => save.isEnabled(), 'a table without problems');
  await page.keyboard.press('Control+s');
  await until(() => /"Neu Ä 2"\s+MW\s*50\s+INT\s+\/\/ Komm 2/.test(saved()), 'the saved symbols');
});

test('a broken file is refused with its places, and nothing is said to have come', async () => {
  await quiet(page);
  const before = await rows.count();
  const broken = join(server.workspace, 'broken.asc');
  writeFileSync(broken, '126,Motor 2\nrubbish without form\n');
  await page.locator('input[type=file][accept]').setInputFiles(broken);
  for (const place of ['1:1', '2:1']) await page.locator('.message').filter({ hasText: `broken.asc:${place}` }).first().waitFor();
  assert.equal(await page.locator('.message').filter({ hasText: /importiert/ }).count(), 0);
  // The file is none of the project.
  assert.equal(await page.locator('.message').getByRole('button', { name: 'Stelle öffnen' }).count(), 0);
  assert.equal(await rows.count(), before);
});

test('the uses of a renamed symbol are replaced, or looked at one by one', async () => {
  const own = await serve('sorting-plant');
  const table = await open(own, 'symbols');
  const source = (name = 'sorting.awl') => readFileSync(join(own.project, name), 'utf-8');
  const rename = async (name) => {
    await table.getByLabel('Symbol 4', { exact: true }).fill(name);
    await until(() => table.getByRole('button', { name: 'Speichern', exact: true }).isEnabled(), 'a table without problems');
    await table.keyboard.press('Control+s');
  };
  const question = table.locator('.renamed');
  await expect(() => table.getByLabel('Symbol 4', { exact: true }).inputValue(), 'Slider small');
  await rename('Slider tiny');
  await until(async () => /"Slider small" → "Slider tiny": 2 Stellen in 2 Dateien/.test(await question.innerText()), 'the question');
  await accessible(table, 'a renamed symbol');
  await question.getByRole('button', { name: 'Ersetzen', exact: true }).click();
  await until(() => source().includes(':= "Slider tiny")') && source('sizes.scn').includes('expect "Slider tiny"'), 'the new name in the sources');
  assert.ok(!source().includes('"Slider small"'));
  await expect(() => question.count(), 0);
  await rename('Slider one');
  await question.getByRole('button', { name: 'Suchen und ersetzen …' }).click();
  const panel = table.locator('#program-panel');
  await expect(() => panel.locator('tr[data-hit] del').count(), 2, 'places');
  await expect(() => panel.locator('tr[data-hit] ins').first().innerText(), '"Slider one"');
  await visit(table, own, 'symbols');
  await question.getByRole('button', { name: 'So lassen' }).click();
  await expect(() => question.count(), 0);
});
