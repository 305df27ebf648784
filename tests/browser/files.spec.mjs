// Source files get other names and go; what merker.toml says of them follows.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { text, toLine } from './editor.mjs';
import { expect, launch, open, scratch, until, visit } from './harness.mjs';

const workspace = scratch();
const at = (path) => join(workspace, path);
writeFileSync(at('merker.toml'), '[project]\nname = "Files"\n\n[program]\nsources = ["main.awl", "drive.awl"]  # in this order\n');
writeFileSync(at('main.awl'), 'ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      CALL  FC 1;\nEND_ORGANIZATION_BLOCK\n');
writeFileSync(at('drive.awl'), 'FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      U     E 0.0;\n      =     A 0.0;\nEND_FUNCTION\n');
const server = await launch(workspace, workspace);
const page = await open(server, 'program?file=drive.awl');
const settings = () => readFileSync(at('merker.toml'), 'utf-8');
const names = () => page.locator('.files .path').allInnerTexts();
const errors = () => page.locator('#program-panel li').count();

test('a source is renamed with what was typed in it', async () => {
  await until(async () => (await text(page)).includes('FC 1'), 'the text');
  await toLine(page, 1);
  await page.keyboard.insertText('// typed before\n');
  await page.getByRole('button', { name: 'Datei umbenennen' }).click();
  await page.getByLabel('Dateiname').fill('lib/antrieb.awl');
  await page.getByRole('dialog').getByRole('button', { name: 'Datei umbenennen' }).click();
  await until(async () => (await names()).includes('lib/antrieb.awl'), 'the new name');
  await until(() => !existsSync(at('drive.awl')), 'the old name gone');
  await until(() => /^\/\/ typed before/.test(readFileSync(at('lib/antrieb.awl'), 'utf-8')), 'what was typed');
  await until(() => settings().includes('["main.awl", "lib/antrieb.awl"]  # in this order'), settings);
  await until(async () => (await text(page)).includes('typed before'), 'the text goes on');
  await expect(errors, 0, 'problems');
});

test('the open file is downloaded as it is shown', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Datei herunterladen' }).press('Enter')]);
  assert.equal(download.suggestedFilename(), 'antrieb.awl');
  assert.equal(readFileSync(await download.path(), 'utf-8'), await text(page));
});

test('a name that is taken is refused, and the file stays', async () => {
  await page.getByRole('button', { name: 'Datei umbenennen' }).click();
  await page.getByLabel('Dateiname').fill('main.awl');
  await page.getByRole('dialog').getByRole('button', { name: 'Datei umbenennen' }).click();
  const refusal = page.getByRole('dialog').getByRole('alert');
  await until(async () => /main\.awl[^]*P1312/.test(await refusal.innerText()), 'the reason in the dialog');
  assert.equal(await page.locator('.messages .message.problem').count(), 0, 'below the view as well');
  await refusal.getByRole('button', { name: 'Meldung schließen' }).click();
  await expect(() => refusal.count(), 0, 'refusals');
  await page.getByRole('dialog').getByRole('button', { name: 'Abbrechen' }).click();
  assert.ok(existsSync(at('lib/antrieb.awl')));
});

test('a deleted source leaves the list as well; merker.toml itself stays', async () => {
  await page.getByRole('button', { name: 'Datei löschen' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Datei löschen' }).click();
  await until(async () => !(await names()).includes('lib/antrieb.awl'), 'one file less');
  await until(() => settings().includes('sources = ["main.awl"]'), settings);
  await until(async () => (await errors()) > 0, 'the call of a block that is gone');
  await page.locator('.files button', { hasText: 'merker.toml' }).click();
  await expect(() => page.getByRole('button', { name: 'Datei löschen' }).count(), 0);
});

test('the program folder stays, whatever is deleted (S7-MGR-07)', async () => {
  await page.locator('.files button', { hasText: 'main.awl' }).click();
  await page.getByRole('button', { name: 'Datei löschen' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Datei löschen' }).click();
  await until(async () => !(await names()).includes('main.awl'), 'no source');
  await visit(page, server, 'projects');
  for (const entry of ['S7-Programm(1)', 'Quellen', 'Bausteine', 'Symbole'])
    await until(async () => (await page.locator('.root').innerText()).includes(entry), entry);
});
