// Diagnostic buffer with help and the way to the block, stacks, module information (S7-MGR-16).
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { statusOf, toLine } from './editor.mjs';
import { expect, launch, open, serve, turn, until, visit, write } from './harness.mjs';

/** The same, as soon as somebody writes into MW 20. */
const COUNTING = `FUNCTION FC 1 : VOID
BEGIN
NETWORK
      L     7;
      L     MW 20;
      BTI   ;
      T     MW 30;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     3;
      L     4;
      CALL  FC 1;
END_ORGANIZATION_BLOCK
`;
/** FC 1 stops the CPU in line 8: BTI of what is no BCD number. */
const FAULTY = `FUNCTION FC 1 : VOID
VAR_TEMP
  local : WORD;
END_VAR
BEGIN
NETWORK
      L     W#16#1234; T #local; L W#16#FFFF;
      BTI   ;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FC 1;
END_ORGANIZATION_BLOCK
`;

/** Kind 3 (others), rack 0, slot 2; a setup with PDUs of 480 bytes. */
const CONNECTION_REQUEST = '0300001611E00000000500C0010AC1020100C2020302';
const SETUP = '0300001902F08032010000000000080000F0000001000101E0';

const server = await serve();
const page = await open(server, 'diagnosis');
let fault;
const has = (locator, words) => until(async () => words.test(await locator.innerText()), words);
const entries = page.getByRole('table').locator('tbody tr');

test('each change of the operating state is an entry, newest first', async () => {
  await turn(page, 'STOP');
  await has(entries.first(), /STOP/);
  await turn(page, 'RUN-P');
  await has(entries.first(), /16#[0-9A-F]{4}[^]*RUN/);
  const heights = await entries.evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().height));
  assert.ok(Math.max(...heights) <= 26, `each event has one line: ${heights}`);
});

test('the diagnostic buffer is saved as a text with all details', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Speichern unter' }).press('Enter')]);
  assert.match(download.suggestedFilename(), /Diagnosepuffer\.txt$/);
  const saved = readFileSync(await download.path(), 'utf-8');
  assert.match(saved, /^Diagnosepuffer\r\n[^]*CPU 314C-2 PtP[^]*\r\nGespeichert am \d{4}-\d\d-\d\d/);
  assert.match(saved, /\r\nNr\.: +1\r\nUhrzeit: +\d\d:\d\d:\d\d\.\d{3}\r\nDatum: +\d{4}-\d\d-\d\d\r\nEreignis: [^\r]*RUN[^\r]*\r\nEreignis-ID: +16#[0-9A-F]{4}\r\n/);
  assert.equal(saved.match(/\r\nNr\.:/g).length, await entries.count());
});

test('the clock of the CPU is set to a typed time, or to that of this computer', async () => {
  await page.getByRole('tab', { name: 'Baugruppenzustand' }).click();
  await page.getByRole('button', { name: 'Uhrzeit stellen' }).press('Enter');
  const dialog = page.getByRole('dialog');
  const clock = dialog.locator('[data-clock]');
  const set = () => dialog.getByRole('button', { name: 'Stellen', exact: true }).press('Enter');
  await dialog.getByLabel('Vom PG/PC übernehmen').uncheck();
  await dialog.getByLabel('Datum').fill('2042-02-28');
  await dialog.getByLabel('Uhrzeit', { exact: true }).fill('23:10:00');
  await accessible(page, 'the clock');
  await set();
  await until(async () => (await clock.innerText()).startsWith('2042-02-28 23:'), 'the typed time');
  await dialog.getByLabel('Datum').fill('2090-01-01');
  await set();
  await dialog.getByRole('alert').filter({ hasText: 'Datum und Uhrzeit der Jahre 1990 bis 2089' }).waitFor();
  assert.match(await clock.innerText(), /^2042-/);
  await dialog.getByLabel('Vom PG/PC übernehmen').check();
  await set();
  await until(async () => (await clock.innerText()).startsWith(`${new Date().getFullYear()}-`), 'the time of this computer');
  await page.keyboard.press('Escape');
});

test('module information shows the CPU and its memory', async () => {
  await page.getByRole('tab', { name: 'Baugruppenzustand' }).click();
  await has(page.getByRole('tabpanel'), /314C-2 PtP/);
});

test('without an S7 server nobody can be connected', async () => {
  await page.getByRole('tab', { name: 'Verbindungen' }).click();
  await has(page.getByRole('tabpanel'), /Kein S7-Server/);
  const weight = await page.locator('footer .phase').evaluate((phase) => getComputedStyle(phase).fontWeight);
  assert.equal(weight, '400'); // only what must be noticed stands out
});

// S7-LIM-05: the connections, who was refused, and a warning that stays where other computers can come.
test('clients of S7 communication are seen', async () => {
  const folder = join(server.workspace, 'served');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[communication]\nconnections = 3\n');
  writeFileSync(join(folder, 'main.awl'), 'ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nNOP 0;\nEND_ORGANIZATION_BLOCK\n');
  const served = await launch(folder, server.workspace, 0, ['--s7', '0.0.0.0:0']);
  const port = Number(served.said().match(/S7 communication: 0\.0\.0\.0:(\d+)/)[1]);
  const clients = [1, 2].map(() => connect(port, '127.0.0.1'));
  const ask = (client, hex) => new Promise((answered) => {
    client.once('data', answered).once('close', answered);
    client.write(Buffer.from(hex, 'hex'));
  });
  // The first one has set up its connection: only such a one keeps its place.
  await ask(clients[0], CONNECTION_REQUEST);
  await ask(clients[0], SETUP);
  await ask(clients[1], CONNECTION_REQUEST);
  const view = await open(served, 'diagnosis');
  await view.getByRole('link', { name: /für andere Rechner offen/ }).click();
  const panel = view.getByRole('tabpanel');
  await has(panel, /1 von 3 Verbindungen belegt/);
  await has(panel, /127\.0\.0\.1:\d+\s+übrige\s+240/);
  await has(panel, /keine Verbindung dieser Art frei/);
  for (let i = 0; i < 2; i++) connect(port, '127.0.0.1').end('GET / HTTP/1.0\r\n\r\n');
  await has(panel, /127\.0\.0\.1: abgebrochen, kein ISO-on-TCP\s+\(2-mal, zuletzt vor \d+ s\)/);
  await has(view.getByRole('alert'), /nicht verschlüsselt/);
  for (const client of clients) client.destroy();
  await has(panel, /0 von 3 Verbindungen belegt/);
});

test('in RUN nothing is interrupted', async () => {
  await page.getByRole('tab', { name: 'Stacks' }).click();
  await has(page.getByRole('tabpanel'), /Kein Baustein/);
});

test('after a fault: "open block" leads to its line (S7-MGR-16)', async () => {
  const folder = join(server.workspace, 'faulty');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[project]\nname = "Faulty"\n');
  writeFileSync(join(folder, 'main.awl'), FAULTY);
  const faulty = await launch(folder, server.workspace);
  fault = await open(faulty, 'diagnosis', { stays: true });
  await fault.locator('[data-mode="STOP"]').waitFor();
  await fault.getByRole('table').locator('tbody tr').filter({ hasText: /16#252/ }).first().click();
  await fault.getByRole('button', { name: 'Baustein öffnen' }).click();
  await fault.locator('.code .cm-content').waitFor();
  await until(() => /file=main\.awl&line=8/.test(fault.url()), 'the line in the address');
  await until(async () => (await fault.locator('.code .cm-activeLine').innerText()).includes('BTI'), 'the line');
});

test('the statement that stopped the CPU is marked, with the registers of that instant', async () => {
  const mark = fault.locator('.code .cm-failed-line');
  await until(async () => (await mark.innerText()).includes('BTI'), 'the mark');
  const bar = fault.getByRole('status').filter({ hasText: 'STOP in FC 1, Zeile 8' });
  await has(bar, /AKKU1 0000FFFF/);
  assert.equal(await bar.getByRole('button').count(), 0, 'it is in sight');
  // The reason is on the front plate; no sentence denies the status that is shown.
  const reason = await fault.locator('aside a[href="#/diagnosis"]').innerText();
  assert.ok(!(await bar.innerText()).includes(reason), reason);
  await fault.getByRole('switch', { name: 'Status' }).click();
  await until(async () => (await statusOf(fault, 8)).includes('0000FFFF'), 'AKKU 1 beside the statement');
  assert.equal(await fault.getByText('Die CPU steht').count(), 0);
  await accessible(fault, 'failed statement');
  await toLine(fault, 1);
  await bar.getByRole('button', { name: 'Zur Anweisung' }).press('Enter');
  await until(async () => (await fault.locator('.code .cm-activeLine').innerText()).includes('BTI'), 'the line');
  await fault.getByRole('switch', { name: 'Status' }).click();
});

test('B stack, I stack and L stack show where it was (S7-MGR-16)', async () => {
  await visit(fault, { address: fault.url().replace(/#.*/, '') }, 'diagnosis');
  await fault.getByRole('tab', { name: 'Stacks' }).click();
  const blocks = fault.getByRole('table').nth(0).locator('tbody tr');
  await has(blocks.first(), /FC 1/);
  await has(blocks.nth(1), /OB 1/);
  const interrupts = fault.getByRole('table').nth(1).locator('tbody tr');
  await has(interrupts.first(), /FFFF/i);
  const locals = fault.getByRole('table').nth(2).locator('tbody tr');
  await has(locals.first(), /12 34/);
  await has(fault.locator('tr[data-local="local"]'), /L 0\.0\s+local\s+WORD\s+W#16#1234/);
  await accessible(fault, 'stacks');
  await blocks.first().getByRole('link').click();
  await until(() => /line=8/.test(fault.url()), 'the line');
});

test('who was not watched: why there is no status, what the operands have, local variables from the L stack', async () => {
  await fault.getByRole('tab', { name: 'Beobachten' }).click();
  await expect(() => fault.locator('tr[data-nearby="#local"] .value.number').innerText(), 'W#16#1234');
  assert.equal(await fault.locator('tr[data-nearby]').count(), 1, 'W#16#FFFF is no operand');
  await toLine(fault, 12);
  await fault.getByRole('switch', { name: 'Status' }).click();
  await fault.getByRole('status').filter({ hasText: /nicht beobachtet oder nicht bearbeitet\..*„Beobachten“/ }).waitFor();
  await fault.getByRole('switch', { name: 'Status' }).click();
});

test('the status of the run that a fault ended stays, also for who leaves the block and comes back', async () => {
  const folder = join(server.workspace, 'counting');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[project]\nname = "Counting"\n');
  writeFileSync(join(folder, 'main.awl'), COUNTING);
  const counting = await launch(folder, server.workspace);
  const look = await open(counting, 'program?file=main.awl&line=4');
  await turn(look, 'RUN-P');
  await look.getByRole('switch', { name: 'Status' }).click();
  await until(async () => (await statusOf(look, 5)).includes('00000000'), 'the status');
  await write(look, { 'MW 20': 'W#16#FFFF' });
  await look.locator('[data-mode="STOP"]').waitFor();
  const ended = async () => (await statusOf(look, 4)).includes('00000007') && (await statusOf(look, 5)).includes('0000FFFF');
  await until(ended, 'the values of the last run');
  await toLine(look, 13);
  await until(async () => !(await ended()), 'the status of another block');
  await toLine(look, 4);
  await until(ended, 'the values of the last run again');
  await look.reload();
  await until(ended, 'the values of the last run after a reload');
});
