// Several stations: the picture of the network, live; stations and lines by click and by keyboard; a second station and its connection
// (S7-MGR-13, S7-NETPRO-02 to S7-NETPRO-08).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, leave, message, open, picture, serve, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const ring = await serve('networks/token-ring');
const page = await open(ring, 'stations');
const card = (name, on = page) => on.locator(`[data-station='${name}']`);
const button = (name, on = page) => on.getByRole('button', { name, exact: true });

test('all stations run, with their addresses', async () => {
  await page.getByRole('heading', { name: 'Netz Token ring' }).waitFor();
  for (const name of ['Cell1', 'Cell2', 'Cell3', 'Cell4', 'Cell5'])
    await expect(() => card(name).getAttribute('data-state'), 'RUN');
  assert.deepEqual((await page.locator(".canvas text").allTextContents()).filter((text) => /^\d$/.test(text)), ['2', '3', '4', '5', '6']);
  await until(async () => !(await page.getByRole('table', { name: 'Subnetze' }).innerText()).includes('\t0 %'), 'the line is busy');
});

test('a click opens a station; all views are about it', async () => {
  await button('Cell3 CPU 314C-2 PtP').click();
  await page.locator('header').getByText('Cell3').waitFor();
  assert.equal(await page.locator('.message').filter({ hasText: 'Eine andere Seite' }).count(), 0, 'it was this page');
  await expect(() => button('Cell3 CPU 314C-2 PtP').getAttribute('aria-current'), 'true');
});

test('one is stopped and goes on', async () => {
  await button('Cell2: STOP').click();
  await expect(() => card('Cell2').getAttribute('data-state'), 'STOP');
  await expect(() => card('Cell1').getAttribute('data-state'), 'RUN');
  await button('Cell2: RUN').focus();
  await page.keyboard.press('Enter');
  await expect(() => card('Cell2').getAttribute('data-state'), 'RUN');
  await button('Cell2: Netz').click();
  await expect(() => card('Cell2').getAttribute('data-state'), 'AUS');
  await button('Cell2: Netz').click();
  await expect(() => card('Cell2').getAttribute('data-state'), 'RUN');
});

test('a plug is pulled and put in again', async () => {
  const plug = button('Cell4: Stecker an MPI(1)');
  await plug.click();
  await expect(() => plug.getAttribute('aria-pressed'), 'false');
  await page.waitForTimeout(300);
  await plug.click();
  await expect(() => plug.getAttribute('aria-pressed'), 'true');
  await until(async () => (await page.getByRole('table', { name: 'Globaldaten' }).innerText()).includes('Paket verloren'), 'GDS tells of it');
});

test('the line is broken and mended', async () => {
  await button('MPI(1) unterbrechen').click();
  await page.getByText('unterbrochen', { exact: true }).waitFor();
  await button('MPI(1) reparieren').click();
  await page.getByText('in Ordnung', { exact: true }).waitFor();
});

const settings = () => readFileSync(join(ring.project, 'merker.toml'), 'utf8');
const addresses = () => page.locator('.canvas svg text:not(.label)').allTextContents();
const address = (station, subnet = 'MPI(1)') => page.getByLabel(`${station}: Adresse an ${subnet}`, { exact: true });
const hardware = () => visit(page, ring, 'hardware?mode=plan');
async function network() {
  await visit(page, ring, 'stations');
  await card('Office').waitFor();
}

// S7-NETPRO-05
test('an empty station leads to the hardware view; its CPU is connected there, and the network shows it', async () => {
  await button('Station hinzufügen').click();
  await page.getByLabel('Name', { exact: true }).fill('Office');
  assert.equal(await page.getByLabel('MPI-Adresse').count(), 0, 'an empty station is not connected');
  await page.keyboard.press('Enter');
  await page.getByRole('tab', { name: 'Konfigurieren', selected: true }).waitFor();
  await page.locator('header').getByText('Office').waitFor();
  await expect(() => address('Office').inputValue(), '');
  await until(() => address('Office').evaluate((field) => field.getBoundingClientRect().bottom < innerHeight), 'it is in sight');
  await button('Office mit MPI(1) vernetzen').click();
  await expect(() => address('Office').inputValue(), '7');
  assert.match(settings(), /\{station = "Office", address = 7\}/);
  await network();
  await expect(async () => (await addresses()).includes('7'), true);
});

// S7-NETPRO-06
test('a double click on a subnet opens its properties; an address of there is that of the hardware view, and back', async () => {
  await page.locator('[data-subnet="MPI(1)"]').first().dblclick();
  const dialog = page.getByRole('dialog', { name: 'Eigenschaften: MPI(1)' });
  await dialog.waitFor();
  await address('Office').fill('9');
  await page.keyboard.press('Enter');
  await until(() => settings().includes('{station = "Office", address = 9}'), 'address 9 in merker.toml');
  assert.ok(await address('Office').evaluate((field) => field === document.activeElement), 'the keyboard stays in the field');
  await address('Office').fill('2');
  await page.keyboard.press('Enter');
  await message(page, 'eindeutig');
  await expect(() => address('Office').inputValue(), '9');
  await leave(page);
  await hardware();
  await expect(() => address('Office').inputValue(), '9');
  assert.equal(await page.getByLabel('MPI-Adresse', { exact: true }).count(), 0, 'the address of a project of one station');
  await address('Office').fill('8');
  await page.keyboard.press('Enter');
  await until(() => settings().includes('{station = "Office", address = 8}'), 'address 8 in merker.toml');
  await network();
  await expect(async () => (await addresses()).includes('8'), true);
});

// S7-NETPRO-03, S7-NETPRO-04
test('a subnet is made in the network, a station drawn to it; the hardware view has it', async () => {
  await button('Subnetz einfügen').click();
  await expect(() => page.getByLabel('Name', { exact: true }).inputValue(), 'MPI(2)');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog', { name: 'Eigenschaften: MPI(2)' }).waitFor();
  await leave(page);
  await button('Schnittstellen von Office').dragTo(page.locator('[data-subnet="MPI(2)"]'));
  await until(() => /name = "MPI\(2\)"\nkind = "mpi"\nnodes = \[\{station = "Office", address = 2\}\]/.test(settings()), 'Office on MPI(2)');
  await hardware();
  await expect(() => address('Office', 'MPI(2)').inputValue(), '2');
  await expect(() => address('Office').inputValue(), '');
  await network();
  await button('Schnittstellen von Office').click();
  await button('Office mit MPI(1) vernetzen').click();
  await expect(() => address('Office', 'MPI(2)').inputValue(), '');
  await leave(page);
});

test('an address that is being typed stays while another change arrives', async () => {
  const other = await open(ring, 'stations');
  await page.locator('[data-subnet="MPI(1)"]').first().dblclick();
  await address('Office').fill('1');
  await other.locator('[data-subnet="MPI(1)"]').first().dblclick();
  await address('Office', 'MPI(1)').waitFor();
  await other.getByLabel('Office: Adresse an MPI(1)', { exact: true }).fill('12');
  await other.keyboard.press('Enter');
  await until(() => settings().includes('{station = "Office", address = 12}'), 'address 12 in merker.toml');
  await expect(async () => (await addresses()).includes('12'), true);
  assert.equal(await address('Office').inputValue(), '1');
  await address('Office').press('End');
  await page.keyboard.type('1');
  await page.keyboard.press('Enter');
  await until(() => settings().includes('{station = "Office", address = 11}'), 'address 11 in merker.toml');
  await address('Office').fill('7');
  await page.keyboard.press('Enter');
  await until(() => settings().includes('{station = "Office", address = 7}'), 'address 7 in merker.toml');
  await leave(page);
  await other.context().close();
});

// S7-NETPRO-03, S7-NET-10
test('a PROFIBUS subnet is made with its master and a slave, and deleted with them', async () => {
  await button('Subnetz einfügen').click();
  await page.getByLabel('Art', { exact: true }).selectOption('PROFIBUS');
  await expect(() => page.getByLabel('Name', { exact: true }).inputValue(), 'PROFIBUS(1)');
  await page.getByLabel('DP-Master').selectOption('Cell1');
  await button('Hinzufügen', page.getByRole('dialog')).click();
  await message(page, 'DP-Schnittstelle');
  await leave(page);
  await button('Station hinzufügen').click();
  await page.getByLabel('Name', { exact: true }).fill('Master');
  await page.getByRole('dialog').getByLabel('CPU', { exact: true }).selectOption('314C-2 DP');
  await page.keyboard.press('Enter');
  await page.getByRole('tab', { name: 'Konfigurieren', selected: true }).waitFor();
  await network();
  await button('Subnetz einfügen').click();
  await page.getByLabel('Art', { exact: true }).selectOption('PROFIBUS');
  await page.getByLabel('DP-Master').selectOption('Master');
  await accessible(page, 'a new PROFIBUS subnet');
  await button('Hinzufügen', page.getByRole('dialog')).click();
  const dialog = page.getByRole('dialog', { name: 'Eigenschaften: PROFIBUS(1)' });
  await dialog.getByText('ET 200M').waitFor();
  await expect(() => address('Master', 'PROFIBUS(1)').inputValue(), '2');
  await button('Subnetz löschen', dialog).click();
  await expect(() => page.getByRole('dialog').count(), 0);
  assert.ok(!settings().includes('PROFIBUS(1)') && !settings().includes('[[slave]]'));
  await button('Office CPU 314C-2 PtP').click();
  await page.locator('header').getByText('Office').waitFor();
});

// The server refuses what was asked of the project before: here it is refused on purpose, and then the project is opened anew.
test('the hardware view opens whenever the project is opened anew', async () => {
  const other = await open(ring, 'stations');
  let refused = '';
  await other.routeWebSocket(/./, (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((text) => {
      const { id, do: method } = JSON.parse(text);
      if (method !== refused) return server.send(text);
      refused = '';
      const problem = { severity: 'error', code: 'P1308', file: '', line: 0, column: 0, length: 0, arguments: [], text: 'refused' };
      socket.send(JSON.stringify({ id, problems: [problem] }));
      server.send(JSON.stringify({ id: 1e9, do: 'stations.reload' }));
    });
  });
  await other.reload();
  for (refused of ['files.list', 'hardware.edit']) {
    const what = refused;
    await visit(other, ring, 'hardware?mode=plan');
    await until(() => refused === '', `${what} was refused`);
    await other.getByRole('toolbar', { name: 'Konfigurieren' }).waitFor();
    await visit(other, ring, 'stations');
    await card('Office', other).waitFor();
  }
});

test('the tree of the project leads to a subnet', async () => {
  await visit(page, ring, 'projects');
  await page.getByRole('link', { name: 'MPI(1), Adresse 7' }).waitFor();
  await page.getByRole('link', { name: 'MPI(2)' }).click();
  const dialog = page.getByRole('dialog', { name: 'Eigenschaften: MPI(2)' });
  await button('Subnetz löschen', dialog).click();
  await expect(() => page.getByRole('dialog').count(), 0);
  assert.ok(!settings().includes('MPI(2)'));
});

test('global data are connected', async () => {
  await button('Globaldaten verbinden').click();
  await page.getByLabel('Empfänger', { exact: true }).selectOption('Office');
  await page.getByLabel('Sender: Bereich').fill('MW 104');
  await page.getByLabel('Empfänger: Bereich').fill('MW 10');
  await page.getByRole('dialog').getByRole('button', { name: 'Globaldaten verbinden' }).click();
  await page.getByText('Office/MW 10').waitFor();
  assert.match(settings(), /from = "Cell1\/MW 104"\nto = \["Office\/MW 10"\]/);
});

test('a connection is made', async () => {
  const line = await serve('networks/connections');
  const other = await open(line, 'stations');
  await button('S7-Verbindung anlegen', other).click();
  const dialog = other.getByRole('dialog');
  await dialog.getByLabel('Von').selectOption('Office');
  await dialog.getByLabel('Zu', { exact: true }).selectOption('Belt');
  await button('Hinzufügen', dialog).click();
  await other.getByText('Belt ist an keinem davon').waitFor();
  await dialog.getByLabel('Zu', { exact: true }).selectOption('Lead');
  await button('Hinzufügen', dialog).click();
  const row = other.getByRole('table', { name: 'S7-Verbindungen' }).getByRole('row', { name: 'Office W#16#2 ruft Lead (Ethernet(1))' });
  await row.waitFor();
  assert.match(readFileSync(join(line.project, 'merker.toml'), 'utf8'), /id = "W#16#2"\nlocal = "Office"\npartner = "Lead"\n/);
});

test('a project of one station becomes one of several', async () => {
  const plant = await serve('vessel-emptying');
  const other = await open(plant, 'projects');
  await other.getByRole('button', { name: /^MPI\(1\)/ }).click();
  await other.getByLabel('Name des neuen Projekts').fill('Two vessels');
  await other.getByLabel('Name dieser Station').fill('Vessel');
  await button('Projekt mit mehreren Stationen', other).click();
  await visit(other, plant, 'stations');
  await expect(() => card('Vessel', other).getAttribute('data-state'), 'RUN');
});

for (const theme of ['light', 'dark'])
  for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]])
    test(`it is accessible and has room at ${width}x${height}, ${theme}`, async () => {
      const small = await open(ring, 'stations', { theme, width, height });
      await card('Cell5', small).waitFor();
      await accessible(small);
      assert.deepEqual(await crowding(small), []);
      const rows = await small.locator('tbody tr').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
      assert.ok(rows.every((height) => height >= 22 && height <= 26), `dense rows: ${rows}`);
      if (theme === 'light' && width === 1280) await picture(small, 'stations-light');
    });
