// Curves over virtual time: record, values, pause, zoom, export.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, launch, open, picture, serve, turn, until, write } from './harness.mjs';

const server = await serve();
const page = await open(server, 'trends', { language: 'en' });
const frame = page.locator('[data-rows]');
const fact = async (name) => Number(await frame.getAttribute(`data-${name}`));
const value = (curve) => page.locator(`li[data-curve='${curve}'] output`).innerText();
async function pause(wanted) {
  const button = page.locator('main').getByRole('button', { name: 'Pause' });
  await button.click();
  await expect(() => button.getAttribute('aria-pressed'), String(wanted));
}
async function add(operand) {
  await page.getByRole('combobox', { name: /Operand/ }).fill(operand);
  await page.keyboard.press('Enter');
  await page.locator(`li[data-curve='${operand}']`).waitFor();
}

test('variables and values of the plant are recorded', async () => {
  await turn(page, 'RUN-P');
  for (const operand of ['"Light barrier small"', '"Slider small"', 'plant.Belt.STROKE_SMALL', 'plant.Belt.SPEED']) await add(operand);
  await until(async () => (await fact('rows')) > 20, 'samples');
  await expect(() => value('plant.Belt.SPEED'), '100 %');
  await until(async () => /^[01]$/.test(await value('"Slider small"')), 'a bit');
  await expect(() => page.locator('.u-over').count(), 1);
  await accessible(page, 'trends with curves');
});

test('what is no operand is refused where it is typed', async () => {
  const box = page.getByRole('combobox', { name: /Operand/ });
  for (const nonsense of ['xx 3', 'Furnace.PV', 'MW 99999']) {
    await box.fill(nonsense);
    await page.keyboard.press('Enter');
    await until(async () => (await page.locator('form .problem').innerText()).length > 5, `the problem of ${nonsense}`);
    assert.equal(await box.inputValue(), nonsense);
    assert.equal(await page.locator('li[data-curve]').count(), 4);
  }
  await box.fill('');
  await expect(() => page.locator('form .problem').innerText(), '');
});

test('a paused chart stands still while recording goes on', async () => {
  await until(async () => (await fact('last')) > 10, 'ten seconds');
  await pause(true);
  const last = await fact('last');
  const cycles = async () => Number(await page.locator('[data-value="cycles"]').innerText());
  const before = await cycles();
  await until(async () => (await cycles()) > before + 200, 'the CPU goes on');
  assert.equal(await fact('last'), last);
  await pause(false);
  await until(async () => (await fact('last')) > last + 0.3, 'the samples of the pause');
  await picture(page, 'trends-light');
});

test('dragging zooms, a double click follows again', async () => {
  const box = await page.locator('.u-over').boundingBox();
  const at = (part) => [box.x + box.width * part, box.y + box.height / 2];
  await page.mouse.move(...at(0.24));
  await page.mouse.down();
  await page.mouse.move(...at(0.32), { steps: 4 });
  await page.mouse.up();
  await until(async () => (await fact('to')) - (await fact('from')) < 10, 'a zoomed range');
  await until(async () => /%$/.test(await value('plant.Belt.SPEED')), 'the value at the cursor');
  await page.mouse.dblclick(...at(0.5));
  await until(async () => (await fact('to')) - (await fact('from')) > 20, 'the whole span');
});

test('CSV has what is in sight, PNG is a picture', async () => {
  await pause(true);
  const [table] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'CSV' }).click()]);
  assert.equal(table.suggestedFilename(), 'Sorting-plant.csv');
  const lines = readFileSync(await table.path(), 'utf-8').trim().split('\r\n');
  assert.equal(lines[0], 'time [s],Light barrier small,Slider small,plant.Belt.STROKE_SMALL,plant.Belt.SPEED [%]');
  assert.ok(lines.length > 20, `${lines.length} lines`);
  assert.match(lines.at(-1), /^\d+\.\d{3},[01],[01],[\d.]+,100$/);
  const [image] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'PNG' }).click()]);
  const bytes = readFileSync(await image.path());
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  assert.ok(bytes.readUInt32BE(16) > 400, 'its width');
  await pause(false);
});

test('the choice of curves outlives a reload', async () => {
  await page.reload();
  await expect(() => page.locator('li[data-curve]').count(), 4);
  await until(async () => (await fact('rows')) > 5, 'samples again');
});

test('on a German page numbers have a comma, and a curve keeps the name that it was given', async () => {
  const folder = join(server.workspace, 'level');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[project]\nname = "Level"\n');
  writeFileSync(join(folder, 'main.awl'), `DATA_BLOCK DB 1
STRUCT
  N : WORD ;
  R : REAL ;
  B : BOOL ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      NOP   0;
END_ORGANIZATION_BLOCK
`);
  const german = await open(await launch(folder, server.workspace), 'trends');
  await turn(german, 'RUN-P');
  await write(german, { 'DB1.R': '21.5' });
  const box = german.getByRole('combobox', { name: /Operand/ });
  for (const operand of ['DB1.R', 'DB1.B']) {
    await box.fill(operand);
    await german.keyboard.press('Enter');
  }
  const row = german.locator("li[data-curve='DB1.R']");
  await expect(() => row.locator('output').innerText(), '21,500');
  await expect(async () => (await row.locator('.names').innerText()).replace(/\s+/g, ' '), 'DB1.R DB1.DBD 2');
  await accessible(german, 'German curves');
});
