// The serial line of X27: telegrams with their meaning, the partner that sends and answers, parameters (PTP-LINE-10, PTP-LINE-11, PTP-LINE-12,
// PTP-PARAM-01 to PTP-PARAM-37 in the page of the sub-module).
import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer, connect } from 'node:net';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { english } from './german.mjs';
import { expect, message, open, picture, root, serve, turn, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const scanner = await serve('technology/barcode-scanner');
const scale = await serve('technology/weighing-scale');
const page = await open(scanner, 'serial', { height: 720 });
const weighing = await open(scale, 'serial', { height: 720 });
const characters = (on = page) => on.getByRole('table', { name: /^(Zeichen auf der Leitung|Characters on the line)$/ });
const told = async (on = page) => (await characters(on).locator('tbody tr').allInnerTexts()).map((row) => row.replace(/\s+/g, ' '));
const lanes = (on = page) => on.getByRole('application', { name: /^(Zeichen|Characters)/ });
const edges = async (on = page) => [Number(await lanes(on).getAttribute('data-from')), Number(await lanes(on).getAttribute('data-to'))];

test('the view is there for a project with X27 and says what is connected', async () => {
  await page.getByRole('link', { name: 'Seriell', exact: true }).waitFor();
  await page.getByRole('heading', { name: 'Serielle Kopplung' }).waitFor();
  await page.getByText('simuliertem Partner').waitFor();
  await page.getByText('9600 8E1', { exact: false }).waitFor();
  await page.getByText('In diesem Zeitraum war die Leitung still.').waitFor();
});

test('a code is sent, is seen on the line and reaches the program', async () => {
  await turn(page, 'RUN-P');
  await page.getByLabel('Sendet', { exact: true }).fill('4006381333931');
  await page.getByLabel('Anhängen').selectOption('CR');
  await page.getByRole('button', { name: 'Senden', exact: true }).click();
  await until(async () => (await told()).some((row) => / Partner 0D CR/.test(row)), 'the end of the code');
  const rows = await told();
  assert.equal(rows.length, 14);
  assert.match(rows[0], /^\d+\.\d{6} \d+\.\d{6} Partner 34 '4'/);
  await expect(() => page.locator('dl').getByText('Zeichen vom Partner').locator('xpath=../dd').innerText(), '14');
  await visit(page, scanner, 'variables');
  await page.locator('tbody tr').last().locator('input').first().fill('MW 20');
  await page.keyboard.press('Tab');
  await expect(async () => (await page.locator("tr[data-operand='MW 20'] .value").innerText()).trim(), 'W#16#0001');
  await visit(page, scanner, 'serial');
  await until(async () => (await told()).length === 14, 'the code is still there');
});

test('what is no telegram is refused with the reason', async () => {
  await page.getByRole('radio', { name: 'Hex' }).click();
  await page.getByLabel('Sendet', { exact: true }).fill('4 5');
  await page.getByRole('button', { name: 'Senden', exact: true }).click();
  await message(page, 'P0994');
  await page.getByLabel('Sendet', { exact: true }).fill('34 0D');
  await page.getByRole('button', { name: 'Senden', exact: true }).click();
  await until(async () => (await told()).length >= 16 || (await told()).at(-2)?.includes('34'), 'two more characters');
});

test('the picture is zoomed with the keyboard, and paused meanwhile', async () => {
  await lanes().focus();
  const before = await edges();
  await page.keyboard.press('+');
  await until(async () => (await edges())[1] - (await edges())[0] < (before[1] - before[0]) * 0.6, 'half as long');
  await expect(() => page.getByRole('button', { name: 'Anhalten' }).getAttribute('aria-pressed'), 'true');
  const zoomed = await edges();
  await page.keyboard.press('ArrowLeft');
  await until(async () => (await edges())[0] < zoomed[0], 'moved');
  await page.keyboard.press('Home');
  await until(async () => (await told())[0]?.includes("34 '4'"), 'the first character');
  await page.keyboard.press('End');
  await expect(() => page.getByRole('button', { name: 'Anhalten' }).getAttribute('aria-pressed'), 'false');
});

test('dragging shows a part', async () => {
  const before = await edges();
  const box = await lanes().boundingBox();
  await page.mouse.move(box.x + box.width * 0.4, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.6, box.y + 40);
  await page.mouse.up();
  await until(async () => (await edges())[1] - (await edges())[0] < (before[1] - before[0]) * 0.5, 'a part');
  await lanes().dblclick({ position: { x: 300, y: 40 } });
  await expect(() => page.getByRole('button', { name: 'Anhalten' }).getAttribute('aria-pressed'), 'false');
});

test('all characters as a file', async () => {
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'CSV' }).click()]);
  assert.match(file.suggestedFilename(), /X27\.csv$/);
  const lines = readFileSync(await file.path(), 'utf-8').split('\r\n');
  assert.equal(lines[0], 'Beginn [s];Ende [s];von;Zeichen;Name;Bedeutung');
  assert.match(lines[1], /^\d+,\d{6};\d+,\d{6};Partner;34;"'4'";""$/);
});

test('a scale answers over 3964R: procedure and telegrams are told in German', async () => {
  await weighing.getByLabel('Spricht').selectOption('3964R');
  await weighing.getByLabel('Wenn das ankommt').fill('W');
  await weighing.getByLabel('sendet er', { exact: true }).fill('01250');
  await weighing.getByLabel('nach ms').fill('30');
  await weighing.getByRole('button', { name: 'Eintragen' }).click();
  await message(weighing, 'Antwort eingetragen');
  await turn(weighing, 'RUN-P');
  await visit(weighing, scale, 'variables');
  const last = weighing.locator('tbody tr').last();
  await last.locator('input').first().fill('E 124.0');
  await weighing.keyboard.press('Tab');
  const row = weighing.locator("tr[data-operand='E 124.0']");
  await row.locator('.modify input').fill('1');
  await weighing.keyboard.press('Enter');
  await visit(weighing, scale, 'serial');
  await weighing.getByLabel('Zeitraum').selectOption('0.5');
  await until(async () => (await told(weighing)).some((row) => row.includes('BCC richtig; 5 Bytes')), async () => (await told(weighing)).join('\n'));
  const rows = await told(weighing);
  for (const wanted of ['X27 02 STX will senden', 'Partner 10 DLE Verbindung steht', "X27 57 'W'", 'Partner 10 DLE Block quittiert'])
    assert.ok(rows.some((row) => row.includes(wanted)), `${wanted} in\n${rows.join('\n')}`);
  assert.deepEqual(await english(weighing), []);
  await weighing.getByLabel('Zeitraum').selectOption('0.1');
  await picture(weighing, 'serial');
});

for (const { theme, language, width, height } of [
  { theme: 'light', language: 'en', width: 1280, height: 720 },
  { theme: 'dark', language: 'de', width: 1920, height: 1080 },
  { theme: 'dark', language: 'en', width: 1024, height: 768 },
  { theme: 'light', language: 'de', width: 1024, height: 768 },
])
  test(`accessible and with room for everything: ${theme}, ${language}, ${width} x ${height}`, async () => {
    const other = await open(scale, 'serial', { theme, language, width, height });
    await until(async () => (await told(other)).length > 0, 'characters');
    await accessible(other, 'serial');
    let found;
    await until(async () => (found = await crowding(other)).length === 0, () => found.join('\n'));
    assert.ok((await other.evaluate(() => document.documentElement.scrollHeight)) <= height);
    await other.context().close();
  });

test('parameters of the sub-module are pages and go into merker.toml (PTP-PARAM-28, PTP-PARAM-34)', async () => {
  const settings = () => readFileSync(join(scale.project, 'merker.toml'), 'utf-8');
  const mask = (name) => weighing.getByRole('tab', { name, exact: true });
  await visit(weighing, scale, 'hardware');
  await weighing.getByRole('tab', { name: 'Konfigurieren' }).click();
  await weighing.locator('tr[data-slot="2.1"]').getByRole('button').click();
  for (const name of ['Grundparameter', 'Übertragung', 'Telegramm', 'Datenempfang', 'Schnittstelle']) await mask(name).waitFor();
  await mask('Übertragung').click();
  await weighing.getByLabel('Baudrate (bit/s)').selectOption('19200');
  await mask('Telegramm').click();
  const delay = weighing.getByLabel('Quittungsverzugszeit (QVZ)');
  await delay.fill('15ms');
  await delay.press('Enter');
  await message(weighing, 'muss 20 bis 65530 ms sein');
  await expect(() => delay.getAttribute('aria-invalid'), 'true');
  await delay.press('Escape');
  await expect(() => delay.inputValue(), '2s');
  await mask('Datenempfang').click();
  assert.ok(await weighing.getByLabel('Max. gepufferte Empfangstelegramme').isDisabled());
  await mask('Schnittstelle').click();
  assert.ok(await weighing.getByLabel('Betriebsart der Schnittstelle').isDisabled());
  await accessible(weighing, 'serial parameters');
  await picture(weighing, 'hardware-serial');
  await weighing.getByRole('button', { name: 'Speichern', exact: true }).click();
  await until(() => settings().includes('baud = 19200'), () => settings());
  assert.ok(settings().includes('priority = "low"\nbaud = 19200'), settings());
});

test('another protocol takes its parameters with it (PTP-OVW-02)', async () => {
  const mask = (name) => weighing.getByRole('tab', { name, exact: true });
  await mask('Grundparameter').click();
  await weighing.getByLabel('Protokoll', { exact: true }).selectOption('ASCII');
  await mask('Endezeichen').click();
  await weighing.getByLabel('Endeerkennung eines Empfangstelegramms').selectOption('characters');
  const marks = weighing.getByLabel('Endezeichen, eines oder zwei (hex)');
  await until(() => marks.isEnabled(), 'end characters');
  await marks.fill('0D 0A');
  await marks.press('Enter');
  const settings = () => readFileSync(join(scale.project, 'merker.toml'), 'utf-8');
  const save = weighing.getByRole('button', { name: 'Speichern', exact: true });
  // A change that comes behind a save waits for the next one.
  await until(async () => {
    if (await save.isEnabled()) await save.click({ timeout: 1000 }).catch(() => {});
    return settings().includes('end_characters = [13,10]');
  }, settings);
  assert.ok(!settings().includes('priority'), settings());
});

/** A port that nobody has now. */
const freePort = () =>
  new Promise((done) => {
    const probe = createServer().listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });

test('[serial] of a project that is opened later connects X27 (PTP-LINE-12)', async () => {
  const port = await freePort();
  const project = join(scanner.workspace, 'merker', 'scale');
  cpSync(join(root, 'examples/technology/weighing-scale'), project, { recursive: true });
  const file = join(project, 'merker.toml');
  const reopen = async (connection) => {
    writeFileSync(file, `${readFileSync(file, 'utf-8').replace(/\n\[serial\][^]*/, '')}\n[serial]\nX27 = "${connection}"\n`);
    await visit(page, scanner, 'projects');
    await page.evaluate((folder) => new Promise((done) => {
      const socket = new WebSocket(`${location.origin.replace('http', 'ws')}/ws`);
      socket.onopen = () => socket.send(JSON.stringify({ id: 1, do: 'projects.open', folder }));
      socket.onmessage = (event) => JSON.parse(event.data).id === 1 && (socket.close(), done());
    }), project);
    await visit(page, scanner, 'serial');
  };
  await reopen(`listen:${port}`);
  await page.getByText(`listen:${port} (127.0.0.1:${port}): niemand da (BREAK)`).waitFor();
  const caller = connect(port, '127.0.0.1');
  await page.getByText('niemand da').waitFor({ state: 'hidden' });
  // What comes while the CPU still starts is lost, as on a real line.
  await until(async () => {
    caller.write('Z');
    return (await told()).some((row) => row.includes("Partner 5A 'Z'"));
  }, 'a character from outside');
  caller.destroy();
  await reopen('device:/dev/ttyS9');
  await page.getByText('nicht geöffnet: nur für das Projekt der Kommandozeile').waitFor();
});
