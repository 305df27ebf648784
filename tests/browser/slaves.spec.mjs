// Slaves of an AS-Interface in the picture of the hardware (S7-NET-17): their bits in the bytes of the CP, their faults.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { open, serve, until } from './harness.mjs';

const server = await serve('networks/as-interface');
const page = await open(server, 'hardware');
const bus = page.getByRole('group', { name: 'AS-Interface am CP auf Steckplatz 4' });

test('the slaves hang on the CP', async () => {
  await bus.getByRole('button', { name: /AS4\/31/ }).waitFor();
  assert.equal(await bus.getByRole('button').count(), 4);
  await bus.getByRole('button', { name: /AS4\/3:/ }).click();
  const terminals = page.getByRole('table', { name: 'Klemmen' });
  await until(async () => (await terminals.getByText('PAB 257', { exact: true }).count()) === 4, 'four outputs in the byte of slave 3');
  await accessible(page, 'slaves of an AS-Interface');
});

test('a slave that fails looks like it', async () => {
  await page.getByRole('switch', { name: 'gezogen' }).click();
  await bus.getByRole('button', { name: /AS4\/3:[^]*gezogen/ }).waitFor();
  await page.getByRole('switch', { name: 'gezogen' }).click();
  await until(async () => (await bus.getByRole('button', { name: /gezogen/ }).count()) === 0, 'the slave is there again');
});

test('a device of a GSD file counts its modules from 1, its head is none of them', async () => {
  const dp = await open(await serve('networks/profibus'), 'hardware');
  const slave = dp.getByRole('group', { name: 'PROFIBUS-DP, Slave mit Adresse 4' });
  await slave.getByRole('button', { name: /DP4\/2: / }).waitFor();
  await slave.getByRole('button', { name: /DP4\/0: / }).click();
  assert.equal(await slave.getByRole('button').count(), 5);
});

// What merker.toml names lies in the folder of the project, for the plan, too: a GSD file.
test('a project with a GSD file is consistent', async () => {
  const other = await open(await serve('networks/profibus'), 'hardware?mode=plan');
  await other.getByText('Die Konfiguration ist konsistent.').waitFor();
  assert.equal(await other.getByText('P0704').count(), 0);
});
