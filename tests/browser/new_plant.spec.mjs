// An axis for a project of one's own: from the parameters of the CPU to the picture, without a line of text.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, launch, open, picture, scratch, until, visit } from './harness.mjs';

const folder = scratch();
const project = join(folder, 'own');
mkdirSync(project);
const settings = `[project]
name = "Own axis"

[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.3"

[[module.channel]]
output = 0
range = "off"

[[module]]
slot = "2.5"
drive = "analog"
max_speed = 2000
increments = 250
`;
writeFileSync(join(project, 'merker.toml'), settings);
const program = (statement) =>
  writeFileSync(join(project, 'ob1.awl'), `ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      ${statement}\nEND_ORGANIZATION_BLOCK\n`);
program('NOP 0');
const server = await launch(project, folder);
program('CALL SFB 44, DB 20');  // its instance is still missing
const page = await open(server, 'process', { language: 'en', width: 1280, height: 720 });
const dialog = page.getByRole('dialog');

test('the data block that a CALL names is offered as its instance', async () => {
  await visit(page, server, 'program');
  await page.getByText('SFB 44').first().waitFor();
  await page.getByRole('button', { name: 'New block' }).first().click();
  await dialog.getByLabel(/^Block, e/).fill('DB 20');
  await expect(() => dialog.getByLabel('Kind of data block').inputValue(), 'instance');
  await expect(() => dialog.getByLabel('Function block').inputValue(), 'SFB 44');
  await dialog.getByRole('button', { name: 'Create' }).click();
  const made = join(project, 'db20.awl');
  await until(() => existsSync(made) && /DATA_BLOCK DB 20 SFB 44/.test(readFileSync(made, 'utf8')), 'the instance');
});

test('an axis is wired as the manual says, and set as the CPU is', async () => {
  await visit(page, server, 'process');
  await page.getByRole('button', { name: 'Add a plant' }).click();
  await expect(() => dialog.getByLabel('Terminal of SETPOINT').inputValue(), '2.3.AO0');
  assert.equal(await dialog.getByLabel('Kind').inputValue(), 'axis');
  assert.equal(await dialog.getByLabel('Terminal of DIRECTION').inputValue(), '');
  await accessible(page, 'a new plant');
  await picture(page, 'new-plant');
  await dialog.getByLabel('Terminal of N').fill('2.2.DI99');
  await dialog.getByRole('button', { name: 'Add and download' }).click();
  await dialog.getByText('has no terminal DI99').waitFor();
  assert.equal(readFileSync(join(project, 'merker.toml'), 'utf8'), settings, 'what cannot be is not written');
  await dialog.getByLabel('Terminal of N').fill('2.2.DI2');
  await dialog.getByRole('button', { name: 'Add and download' }).click();
  await page.getByRole('tab', { name: 'Commissioning' }).waitFor();
  const written = readFileSync(join(project, 'merker.toml'), 'utf8');
  assert.ok(written.startsWith(settings), 'the rest of the file stays');
  assert.match(written, /\[\[plant\]\]\nname = "Axis"\nkind = "axis"\nspeed = 2000\n.*increments = 250\n\n\[plant.wire\]\n/s);
  assert.match(written, /ENABLE = "2.2.DO6"/);
});

test('the pages of its parameters fit into the window', async () => {
  await visit(page, server, 'hardware?mode=plan');
  await page.getByText('Position on board').click();
  await page.getByRole('tab', { name: 'Drive' }).click();
  const wide = await page.evaluate(() => document.querySelector('main')?.scrollWidth - document.querySelector('main')?.clientWidth);
  assert.ok(wide <= 0, `${wide} pixels too wide`);
});
