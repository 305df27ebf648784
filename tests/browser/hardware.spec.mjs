// The rack as a picture, properties, faults (S7-HWCFG-01, S7-HWCFG-02).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, serve, until, visit } from './harness.mjs';

const server = await serve('03-hardware');
const page = await open(server, 'hardware');

test('the rack shows its modules with their addresses', async () => {
  const module = page.getByRole('button', { name: /SM 321/ }).first();
  await until(async () => /E 0\.0/.test(await module.innerText()), 'the address');
});

test('a chosen module shows terminals and properties', async () => {
  await page.getByRole('button', { name: /SM 321/ }).first().click();
  await page.getByRole('table', { name: 'Klemmen' }).getByText('E 0.0', { exact: true }).waitFor();
});

test('a pulled module is a diagnostic event', async () => {
  const module = page.getByRole('button', { name: /SM 321/ }).first();
  await module.click();
  const before = await page.getByRole('switch').first().getAttribute('aria-checked');
  await page.getByRole('switch').first().click();
  await until(async () => (await page.getByRole('switch').first().getAttribute('aria-checked')) !== before, 'the fault');
  await visit(page, server, 'diagnosis');
  await page.getByRole('table').locator('tbody tr').first().waitFor();
});
