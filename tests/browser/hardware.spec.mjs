// The rack as a picture, properties, faults (S7-HWCFG-01, S7-HWCFG-02).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
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
  const before = await page.getByRole('switch', { name: 'gezogen' }).getAttribute('aria-checked');
  await page.getByRole('switch', { name: 'gezogen' }).click();
  await until(async () => (await page.getByRole('switch', { name: 'gezogen' }).getAttribute('aria-checked')) !== before, 'the fault');
  await visit(page, server, 'diagnosis');
  await page.getByRole('table').locator('tbody tr').first().waitFor();
});

test('the event leads to the module, which looks pulled (S7-DIAG-01)', async () => {
  const event = page.getByRole('table').locator('tbody tr').filter({ hasText: '16#3961' }).first();
  assert.match(await event.innerText(), /Limit switches \(Baugruppenträger 0, Steckplatz 4\)/);
  const cut = () => event.getByRole('button').evaluate((one) => one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight);
  assert.equal(await cut(), false, 'the module and its slot are read in the row');
  await event.getByRole('button').press('Enter');
  let seen;
  const told = page.locator('[data-module="0/4"]');
  await until(async () => /Limit switches, Baugruppenträger 0, Steckplatz 4, Adresse 0/.test((seen = await told.innerText())), () => `the module, seen ${seen}`);
  await accessible(page, 'event of a module');
  await page.getByRole('button', { name: 'Baugruppe zeigen' }).press('Enter');
  await until(() => decodeURIComponent(page.url()).endsWith('hardware?module=0/4'), 'the module in the address');
  const front = page.getByRole('button', { name: /SM 321[^]*gezogen/ });
  await until(async () => (await front.getAttribute('aria-pressed')) === 'true', 'the chosen module');
  assert.equal(await front.locator('.lamp.on').count(), 0);
  const values = await page.getByRole('table', { name: 'Klemmen' }).locator('td.number').allInnerTexts();
  assert.deepEqual([...new Set(values)], ['']);
  await accessible(page, 'pulled module');
});

test('a faulty module looks so until its fault is gone', async () => {
  await visit(page, server, 'hardware?module=0/4');
  const front = page.getByRole('button', { name: /, gestört$/ });
  const fault = page.getByRole('switch', { name: 'Lastspannung fehlt' });
  await page.getByRole('switch', { name: 'gezogen' }).press('Space');
  await page.getByRole('button', { name: /SM 321[^]*gezogen/ }).waitFor({ state: 'detached' });
  await fault.press('Space');
  await front.waitFor();
  await accessible(page, 'faulty module');
  await fault.press('Space');
  await front.waitFor({ state: 'detached' });
  await page.getByRole('switch', { name: 'gezogen' }).press('Space');
  await page.getByRole('button', { name: /SM 321[^]*gezogen/ }).waitFor();
});
