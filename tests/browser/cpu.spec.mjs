// The CPU panel and the frame: S7-SIM-09, S7-SIM-11, S7-SIM-13, S7-MGR-14, S7-MGR-16.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { expect, leave, open, serve, turn, until } from './harness.mjs';

const server = await serve();
const page = await open(server);
const led = (name) => page.locator(`[data-led="${name}"]`).getAttribute('data-state');
const cycles = async () => Number(await page.locator('[data-value="cycles"]').innerText());
const button = (name) => page.getByRole('button', { name, exact: true });

test('RUN: its LED is on and the cycle counter increases (S7-SIM-09, S7-SIM-11)', async () => {
  await turn(page, 'RUN-P');
  await expect(() => led('RUN'), 'on');
  await expect(() => led('STOP'), 'off');
  await expect(() => led('DC5V'), 'on');
  const before = await cycles();
  await until(async () => (await cycles()) > before, 'more cycles');
});

test('STOP: its LED is on and the cycle counter stands (S7-SIM-11)', async () => {
  await turn(page, 'STOP');
  await expect(() => led('STOP'), 'on');
  await expect(() => led('RUN'), 'off');
  await turn(page, 'RUN-P');
});

test('a paused CPU makes exactly one cycle at a time (S7-SIM-13)', async () => {
  await button('Pause').click();
  await until(() => button('Ein Zyklus').isEnabled(), 'the step button');
  const before = await cycles();
  for (let step = 1; step <= 3; ++step) {
    await button('Ein Zyklus').click();
    await expect(cycles, before + step);
  }
  await button('Echtzeit').click();
  await until(async () => (await cycles()) > before + 10, 'cycles in real time');
});

test('power off: dark; power on: as before', async () => {
  await button('Netz').click();
  await expect(() => led('DC5V'), 'off');
  await button('Netz').click();
  await expect(() => led('DC5V'), 'on');
  await expect(() => led('RUN'), 'on');
});

test('an event without its OB stops the CPU, and the panel says why (S7-SIM-13)', async () => {
  await button('Mehr …').click();
  await page.getByRole('button', { name: /^OB 82/ }).click();
  await leave(page);
  await expect(() => led('STOP'), 'on');
  await expect(() => led('SF'), 'on');
  await until(async () => /82/.test(await page.locator('aside').innerText()), 'the reason');
  await button('Mehr …').click();
  await page.getByRole('button', { name: 'geht: OB 82' }).click();
  await leave(page);
  await turn(page, 'STOP');
  await turn(page, 'RUN-P');
  await expect(() => led('RUN'), 'on');
  await expect(() => led('SF'), 'off');
});

test('the clock is set from the front plate as well', async () => {
  await button('Mehr …').click();
  await page.getByRole('button', { name: 'Uhrzeit stellen' }).press('Enter');
  await expect(() => page.getByRole('dialog').count(), 1);
  await page.getByRole('dialog').getByRole('button', { name: 'Stellen', exact: true }).press('Enter');
  const year = String(new Date().getFullYear());
  await until(async () => (await page.locator('aside [title="Uhr der CPU"]').innerText()).startsWith(year), 'the time of this computer');
  await leave(page);
});

test('memory reset is asked for first; cancelling keeps the program', async () => {
  await page.getByRole('radio', { name: 'MRES' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Abbrechen' }).click();
  await expect(() => led('RUN'), 'on');
});

test('F1 explains the view and lists the keys (S7-MGR-14)', async () => {
  await page.keyboard.press('F1');
  const text = await page.getByRole('dialog').innerText();
  assert.match(text, /Diese Ansicht: E\/A/);
  assert.match(text, /Alt/);
  await leave(page);
});

test('keys lead to views and switch the CPU', async () => {
  await page.keyboard.press('Alt+Digit2');
  await page.locator('nav a[href="#/hardware"][aria-current]').waitFor();
  await page.keyboard.press('Alt+KeyS');
  await expect(() => led('STOP'), 'on');
  await page.keyboard.press('Alt+KeyR');
  await expect(() => led('RUN'), 'on');
});

test('the language switch changes every word and is kept', async () => {
  await page.getByRole('button', { name: 'Switch to English' }).click();
  await page.getByRole('button', { name: 'Real', exact: true }).waitFor();
  await expect(() => page.locator('html').getAttribute('lang'), 'en');
  await expect(() => page.evaluate(() => localStorage.getItem('merker.language')), '"en"');
});

test('what was refused is gone when it has been done, or when another view opens', async () => {
  const own = await serve();
  const page = await open(own, 'program?file=sorting.awl');
  const refusal = page.locator('.message.problem');
  await turn(page, 'RUN');
  await page.locator('.bar').getByRole('button', { name: 'Laden', exact: true }).click();
  await refusal.first().waitFor();
  await turn(page, 'RUN-P');
  await page.locator('.bar').getByRole('button', { name: 'Laden', exact: true }).click();
  await page.locator('.message.done').first().waitFor();
  await expect(() => refusal.count(), 0, 'refusals');
  await turn(page, 'RUN');
  await page.locator('.bar').getByRole('button', { name: 'Laden', exact: true }).click();
  await refusal.first().waitFor();
  await page.locator('header nav').getByRole('link', { name: 'E/A' }).click();
  await expect(() => refusal.count(), 0, 'refusals');
});
