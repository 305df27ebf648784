// Diagnostic buffer with help and the way to the block, stacks, module information (S7-MGR-16).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open, serve, turn, until } from './harness.mjs';

const server = await serve();
const page = await open(server, 'diagnosis');
const entries = page.getByRole('table').locator('tbody tr');

test('each change of the operating state is an entry, newest first', async () => {
  await turn(page, 'STOP');
  await until(async () => /STOP/.test(await entries.first().innerText()), 'STOP on top');
  await turn(page, 'RUN-P');
  await until(async () => /RUN/.test(await entries.first().innerText()), 'RUN on top');
  assert.match(await entries.first().innerText(), /16#[0-9A-F]{4}/);
});

test('module information shows the CPU and its memory', async () => {
  await page.getByRole('tab', { name: 'Baugruppenzustand' }).click();
  await until(async () => /314C-2 PtP/.test(await page.getByRole('tabpanel').innerText()), 'the model');
});

test('in RUN nothing is interrupted', async () => {
  await page.getByRole('tab', { name: 'Stacks' }).click();
  await until(async () => /Kein Baustein/.test(await page.getByRole('tabpanel').innerText()), 'no stack');
});
