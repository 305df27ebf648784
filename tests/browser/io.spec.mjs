// Tiles: S7-SIM-03, S7-SIM-10, S7-SIM-12, S7-VIS-09.
import { test } from 'node:test';
import { bit, expect, open, serve, turn, until, visit } from './harness.mjs';

const server = await serve();
const page = await open(server);
const value = (operand) => page.locator(`input[data-operand="${operand}"]`).inputValue();
async function add(operand, on = page) {
  await on.locator('#tile-operand').fill(operand);
  await on.locator('#tile-operand').press('Enter');
}

test('the first tiles are those of the symbols, with their names (S7-SIM-03)', async () => {
  await page.getByRole('article', { name: 'EB 0' }).waitFor();
  await page.getByRole('article', { name: 'AB 1' }).waitFor();
  await until(async () => /Light barrier small/.test(await page.getByRole('article', { name: 'EB 0' }).innerText()), 'symbols');
});

test('a click on an input toggles it and the program reacts (S7-SIM-10, S7-VIS-09)', async () => {
  const lamp = await open(await serve('06-first-program'));
  await turn(lamp, 'RUN-P');
  const press = (operand) => lamp.locator(`button[data-operand="${operand}"]`).click();
  await add('EB 0', lamp);
  await add('AB 3', lamp);
  for (const operand of ['E 0.0', 'E 0.1', 'A 3.0']) await expect(() => bit(lamp, operand), '0');
  await press('E 0.0');
  await expect(() => bit(lamp, 'E 0.0'), '1');
  await press('E 0.1');
  await expect(() => bit(lamp, 'A 3.0'), '1');
  await press('E 0.0');
  await expect(() => bit(lamp, 'A 3.0'), '0');
});

test('tiles are added and removed, and the browser keeps them (S7-SIM-03)', async () => {
  await add('mw 10');
  await page.getByRole('article', { name: 'MW 10' }).waitFor();
  await page.reload();
  await page.getByRole('article', { name: 'MW 10' }).waitFor();
  await add('T 9');
  await page.getByRole('button', { name: 'T 9 entfernen' }).click();
  await expect(() => page.getByRole('article', { name: 'T 9' }).count(), 0);
});

test('a tile that is added before the symbols are known stays', async () => {
  const server = await serve('09-symbols');
  const fresh = await open(server, 'hardware');
  await fresh.evaluate(() => {
    const { send } = WebSocket.prototype;
    const held = (window.held = []);
    WebSocket.prototype.send = function (text) {
      if (text.includes('symbols.read')) held.push(() => send.call(this, text));
      else send.call(this, text);
    };
  });
  await visit(fresh, server, 'io');
  await add('MW 90', fresh);
  await fresh.getByRole('article', { name: 'MW 90' }).waitFor();
  await fresh.evaluate(() => window.held.forEach((answer) => answer()));
  await fresh.getByRole('article', { name: 'AB 1' }).waitFor();
  await expect(() => fresh.getByRole('article', { name: 'MW 90' }).count(), 1);
});

test('what is no operand is refused with what would be right', async () => {
  await add('E 0.0');
  await until(async () => /EB, AB, MB/.test(await page.locator('#tile-wrong').innerText()), 'what would be right');
  await page.locator('#tile-operand').fill('');
});

test('another format shows the same value (S7-SIM-12)', async () => {
  await page.locator('input[data-operand="MW 10"]').fill('16#00FF');
  await page.keyboard.press('Enter');
  await expect(async () => (await value('MW 10')).includes('00FF'), true);
  const format = page.getByLabel('Format von MW 10');
  await format.selectOption('DEC');
  await expect(() => value('MW 10'), '255');
  await format.selectOption('BIN');
  await expect(async () => /1111_?1111$/.test(await value('MW 10')), true);
  await format.selectOption('HEX');
  await expect(async () => (await value('MW 10')).includes('00FF'), true);
});

test('a wrong value is a problem in words, the old one stays', async () => {
  await page.locator('input[data-operand="MW 10"]').fill('16#12345');
  await page.keyboard.press('Enter');
  await page.locator('.message.problem').waitFor();
  await page.keyboard.press('Escape');
  await expect(async () => (await value('MW 10')).includes('00FF'), true);
});

test('the slider writes', async () => {
  await page.getByLabel('Schieber für MW 10').press('ArrowRight');
  await expect(async () => (await value('MW 10')).includes('0100'), true);
});

test('in English inputs and outputs are I and Q', async () => {
  const english = await open(server, 'io', { language: 'en' });
  await expect(() => english.locator('button[data-operand="E 0.0"] .address').innerText(), 'I 0.0');
  await english.getByRole('heading', { name: 'QB 1' }).waitFor();
  for (const name of ['Remove QB 1', 'Format of QB 1', 'Value for QB 1']) await english.getByLabel(name, { exact: true }).waitFor();
  await expect(() => english.locator('[aria-label*="EB 0"], [aria-label*="AB 1"]').count(), 0);
  await expect(() => page.locator('button[data-operand="E 0.0"] .address').innerText(), 'E 0.0');
});
