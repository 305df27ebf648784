// Timers by hand, the CPU in a file, recording and playback (S7-SIM-13).
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { expect, leave as escape, message, open, serve, turn, until } from './harness.mjs';

const server = await serve('16-timers');
const page = await open(server);
const file = (name) => join(server.project, name);
const button = (name) => page.getByRole('button', { name, exact: true });
const dialog = page.getByRole('dialog');
const inside = (name) => dialog.getByRole('button', { name, exact: true });
const simulate = () => button('Simulator …').click();
const leave = () => escape(page);
const value = (operand) => page.locator(`input[data-operand="${operand}"]`);
const cycles = async () => Number(await page.locator('[data-value="cycles"]').innerText());

async function add(operand) {
  await page.locator('#tile-operand').fill(operand);
  await page.locator('#tile-operand').press('Enter');
}

test('a timer by hand is set and stands; all are reset', async () => {
  await turn(page, 'RUN-P');
  await add('T 30');
  await add('MB 77');
  await simulate();
  await dialog.getByRole('switch', { name: /Von Hand/ }).click();
  await expect(() => dialog.getByRole('switch', { name: /Von Hand/ }).getAttribute('aria-checked'), 'true');
  await leave();
  await value('T 30').fill('S5T#3S');
  await value('T 30').press('Enter');
  const before = await cycles();
  await until(async () => (await cycles()) > before + 500, 'cycles');
  await expect(() => value('T 30').inputValue(), 'S5T#3S');
  await simulate();
  await inside('Alle Zeiten zurücksetzen').click();
  await dialog.getByRole('switch', { name: /Von Hand/ }).click();
  await leave();
  await until(async () => /^S5T#0/.test(await value('T 30').inputValue()), 'a timer at 0');
});

test('the state of the CPU is saved, loaded, and refused by another CPU', async () => {
  await value('MB 77').fill('B#16#5A');
  await value('MB 77').press('Enter');
  await simulate();
  await dialog.getByLabel('Name des Zustands').fill('middle');
  await inside('Sichern').click();
  await until(() => existsSync(file('middle.state')), 'the file');
  await leave();
  await value('MB 77').fill('B#16#00');
  await value('MB 77').press('Enter');
  await turn(page, 'STOP');
  await simulate();
  await dialog.getByLabel('Gesicherter Zustand').selectOption('middle');
  await inside('Laden').click();
  await page.locator('[data-mode="RUN"]').waitFor();
  await leave();
  await until(async () => /5A/i.test(await value('MB 77').inputValue()), 'the value that was saved');
  const other = { ...JSON.parse(readFileSync(file('middle.state'), 'utf-8')), cpu: '412-1' };
  writeFileSync(file('other.state'), JSON.stringify(other));
  await simulate();
  await until(async () => (await dialog.getByLabel('Gesicherter Zustand').innerText()).includes('other'), 'the other file');
  await dialog.getByLabel('Gesicherter Zustand').selectOption('other');
  await inside('Laden').click();
  await message(page, '412-1');
  await leave();
});

test('what is done is recorded and played back', async () => {
  await simulate();
  await inside('Aufzeichnen').click();
  await dialog.getByText('0 Aktionen aufgezeichnet').waitFor();
  await leave();
  await value('MB 77').fill('B#16#11');
  await value('MB 77').press('Enter');
  await until(async () => /11/.test(await value('MB 77').inputValue()), 'the value');
  await simulate();
  await dialog.getByLabel('Name der Aufzeichnung').fill('press');
  await inside('Beenden und sichern').click();
  const recorded = () => readFileSync(file('press.rec'), 'utf-8');
  await until(() => existsSync(file('press.rec')) && /^\{"at":\d+,"do":"variables.write"/.test(recorded()), 'the file');
  // Ten minutes: however slowly the browser clicks, it can be held; then time runs as fast as it can.
  writeFileSync(file('press.rec'), recorded().replace(/"at":\d+/, '"at":600000000000'));
  await leave();
  await value('MB 77').fill('B#16#00');
  await value('MB 77').press('Enter');
  await simulate();
  await dialog.getByLabel('Gesicherte Aufzeichnung').selectOption('press');
  await inside('Abspielen').click();
  await inside('Wiedergabe anhalten').click();
  await dialog.locator('[data-playback="paused"]').waitFor();
  await inside('Wiedergabe fortsetzen').click();
  await dialog.locator('[data-playback="playing"]').waitFor();
  await leave();
  await page.getByRole('group', { name: 'Zeitablauf' }).getByRole('button', { name: 'Schnell' }).click();
  await until(async () => /11/.test(await value('MB 77').inputValue()), 'the value of the recording');
});
