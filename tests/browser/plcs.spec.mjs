// Several projects on one server, a PLC each, and the copies of examples in the language of the page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, message, open, picture, serve, turn, until } from './harness.mjs';

const server = await serve('06-first-program');
const page = await open(server, 'projects');
const plcs = page.getByRole('navigation', { name: 'SPS dieses Servers' });

test('another PLC is opened with the keyboard alone; the first one goes on', async () => {
  await turn(page, 'RUN-P');
  const other = await open(server, 'projects');
  await other.getByRole('link', { name: 'Weitere SPS …' }).press('Enter');
  await other.getByRole('heading', { name: 'Kein Projekt geöffnet' }).waitFor();
  assert.match(other.url(), /\?plc=2#/);
  assert.deepEqual(await other.locator('.message').allInnerTexts(), [], 'an empty PLC is no error');
  await other.getByRole('button', { name: /^Öffnen: Garagentor/ }).press('Enter');
  await message(other, /Garagentor/);
  await other.locator('header .project', { hasText: 'PLC 2: Garagentor' }).waitFor();
  await accessible(other, 'two PLCs');
  await expect(() => plcs.locator('li').count(), 3);
  await plcs.getByText('Garagentor').waitFor();
  await page.locator('header .project', { hasText: /PLC 1: / }).waitFor();
  await page.locator('[data-mode="RUN"]').waitFor();
  await picture(page, 'plcs');

  // After the page has been loaded anew it is where it was.
  await other.reload();
  await other.locator('header .project', { hasText: 'PLC 2: Garagentor' }).waitFor();
});

test('a copy that is made in German has German symbols, comments and titles', async () => {
  const copy = join(server.workspace, 'merker', 'garage-door');
  const symbols = readFileSync(join(copy, 'door.sym'), 'utf-8');
  assert.match(symbols, /"Warnlampe" +A 1\.2 +BOOL +\/\/ blinkt, während das Tor fährt/);
  assert.match(readFileSync(join(copy, 'door.awl'), 'utf-8'), /TITLE = Die Lampe blinkt während der Fahrt/);
});

test('what one PLC has open another one does not open', async () => {
  const third = await open(server, 'projects');
  await third.getByRole('link', { name: 'Weitere SPS …' }).click();
  await third.getByRole('button', { name: /^Öffnen: Garagentor/ }).click();
  await message(third, /SPS 2 hat ihn geöffnet/);
});

test('who would take a running PLC from others is offered another one', async () => {
  const other = await open(server, 'projects');
  await until(async () => Number(await plcs.locator('li').count()) >= 2, 'the list');
  await other.getByRole('button', { name: /^Öffnen: Aufzug/ }).click();
  const dialog = other.getByRole('dialog', { name: 'Projekt wechseln' });
  await dialog.getByRole('button', { name: 'An einer weiteren SPS öffnen' }).click();
  await until(() => /\?plc=\d#/.test(other.url()), 'another PLC');
  await other.getByRole('heading', { name: 'Kein Projekt geöffnet' }).waitFor();
  await page.locator('[data-mode="RUN"]').waitFor();
});

test('who would close a running one is asked just that', async () => {
  const other = await open(server, 'projects');
  await other.getByRole('button', { name: 'Schließen' }).first().click();
  const dialog = other.getByRole('dialog', { name: 'Projekt schließen' });
  await dialog.getByText('Alle Seiten sind danach ohne Projekt').waitFor();
  assert.equal(await dialog.getByRole('button', { name: 'An einer weiteren SPS öffnen' }).count(), 0);
  await dialog.getByRole('button', { name: 'Abbrechen' }).click();
});

test('where there is no such PLC, the page says so and is at the first one', async () => {
  for (const wrong of ['9', '0', 'abc']) {
    const lost = await open(server, 'projects');
    await lost.goto(server.address.replace(/\/$/, `/?plc=${wrong}#/projects`));
    await message(lost, new RegExp(`keine SPS ${wrong}\\. Diese Seite ist an SPS 1`));
    await until(() => !lost.url().includes('plc='), 'the address of the first one');
    await lost.locator('header .project', { hasText: /PLC 1: / }).waitFor();
  }
});

test('the wizard makes a project of a SINUMERIK, with the keyboard alone', async () => {
  const mill = await open(server, 'projects');
  await mill.goto(server.address.replace(/\/$/, '/?plc=4#/projects'));
  await mill.getByRole('button', { name: 'Neues Projekt …' }).press('Enter');
  const dialog = mill.getByRole('dialog');
  await dialog.getByLabel('Projektname').fill('Fräse');
  await dialog.getByLabel('CPU-Typ').selectOption('SINUMERIK 810 GA3');
  await accessible(mill, 'wizard of STEP 5');
  assert.equal(await dialog.getByLabel('MPI-Adresse').count(), 0, 'it has no MPI');
  await dialog.getByRole('button', { name: 'Anlegen' }).press('Enter');
  await message(mill, /Fräse angelegt\. Die PLC steht in STOP: .* dann RUN\./);
  await until(async () => (await mill.locator('.code .cm-content').innerText()).includes('NETZWERK 1'), 'the listing');
  assert.equal(await mill.getByTitle(/älteren Stand/).count(), 0, 'the listing is in the PLC');
});
