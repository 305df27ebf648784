// The variable table: monitor, modify, force, files (S7-MGR-16).
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { expect, open, serve, turn, until } from './harness.mjs';

const server = await serve();
const page = await open(server, 'variables');
const row = (operand) => page.locator(`tr[data-operand='${operand}']`);
const status = (operand) => row(operand).locator('.value').innerText();
async function type(operand) {
  await page.locator('tbody tr').last().locator('input').first().fill(operand);
  await page.keyboard.press('Tab');
}

test('operands by address and by symbol show their status', async () => {
  await turn(page, 'RUN-P');
  await type('MW 20');
  await type('"Light barrier small"');
  await until(async () => (await status('MW 20')).includes('0'), 'a value');
  await until(async () => /^(0|1|TRUE|FALSE)$/i.test(await status('"Light barrier small"')), 'a bit');
});

test('modify writes all modify values at once', async () => {
  await row('MW 20').locator('.modify input').fill('W#16#1234');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

test('forcing shows a red F, the FRCE LED and the force list; releasing ends all three', async () => {
  await row('"Light barrier small"').locator('.modify input').fill('1');
  await row('"Light barrier small"').getByRole('button', { name: /forcen$/ }).click();
  await row('"Light barrier small"').locator('.mark b').waitFor();
  await expect(() => page.locator('[data-led="FRCE"]').getAttribute('data-state'), 'on');
  await page.getByRole('button', { name: 'Alle aufheben' }).click();
  await expect(() => page.locator('[data-led="FRCE"]').getAttribute('data-state'), 'off');
  await expect(() => row('"Light barrier small"').locator('.mark b').count(), 0);
});

test('monitored and modified at a trigger point (S7-MGR-16)', async () => {
  const dialog = page.getByRole('dialog');
  const trigger = async (what, point, once = false) => {
    await page.getByRole('button', { name: 'Trigger …' }).click();
    const part = dialog.getByRole('group', { name: what });
    await part.getByLabel('Triggerpunkt').selectOption(point);
    if (point !== 'now') await part.getByLabel('nur einmal').setChecked(once);
    await dialog.locator('footer').getByRole('button', { name: 'Schließen' }).click();
  };
  await trigger('Beobachten', 'stop');
  await trigger('Steuern', 'stop', true);
  await row('MW 20').locator('.modify input').fill('W#16#4711');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await page.locator('[data-modifying="stop"]').waitFor();
  assert.doesNotMatch(await status('MW 20'), /4711/);
  await turn(page, 'STOP');
  await expect(async () => (await status('MW 20')).includes('4711'), true);
  await expect(() => page.locator('[data-modifying]').count(), 0);
  await turn(page, 'RUN-P');
  await trigger('Beobachten', 'now');
  await trigger('Steuern', 'now');
  await row('MW 20').locator('.modify input').fill('W#16#1234');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

test('an operand that does not exist is told in its row', async () => {
  await type('EW 99999');
  await row('EW 99999').locator('.problem').waitFor();
  await row('EW 99999').getByRole('button', { name: /löschen$/ }).click();
});

test('a table is saved as a file of the project and opened again', async () => {
  await page.getByRole('button', { name: 'Speichern unter …' }).click();
  await page.locator('#table-name').fill('belt');
  await page.keyboard.press('Enter');
  const table = join(server.project, 'belt.vat');
  await until(() => existsSync(table) && /^MW 20 ; AUTO ; W#16#1234$/m.test(readFileSync(table, 'utf-8')), table);
  await expect(() => page.locator('#variable-table').inputValue(), 'belt.vat');
  await page.getByRole('button', { name: 'Neu', exact: true }).click();
  await expect(() => page.locator('tbody tr').count(), 1);
  await page.locator('#variable-table').selectOption('belt.vat');
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

test('only what can be forced offers it; operands are not cut', async () => {
  const fresh = await open(server, 'variables');
  const line = (operand) => fresh.locator(`tr[data-operand='${operand}']`);
  for (const operand of ['E 0.0', 'MW 20', '"Light barrier small"', 'DB99.DBW 0']) {
    await fresh.locator('tbody tr').last().locator('input').first().fill(operand);
    await fresh.keyboard.press('Tab');
  }
  await line('E 0.0').getByRole('button', { name: /forcen$/ }).waitFor();
  await line('"Light barrier small"').getByRole('button', { name: /forcen$/ }).waitFor();
  for (const operand of ['MW 20', 'DB99.DBW 0']) {
    await line(operand).locator('.quiet').waitFor();
    assert.equal(await line(operand).getByRole('button', { name: /forcen$/ }).count(), 0, operand);
  }
  const field = line('"Light barrier small"').locator('.operand input');
  await until(() => field.evaluate((one) => one.scrollWidth <= one.clientWidth), 'the whole operand');
});
