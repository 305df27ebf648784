// The German page is German: every view, with a program full of errors and a CPU in STOP.
import assert from 'node:assert/strict';
import { rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { english, germanProject, refusedSources } from './german.mjs';
import { launch, open, scratch, turn, until, visit } from './harness.mjs';

const workspace = scratch();
const server = await launch(germanProject(workspace), workspace);
const page = await open(server, 'projects');
const german = async (scope) => assert.deepEqual(await english(page, scope), []);
// Anew: without the dialogs and messages of the test before.
async function see(view) {
  await visit(page, server, view);
  await page.reload();
  await page.locator('main h1').waitFor();
  await page.locator('[data-phase="open"]').waitFor();
}

test('English is seen where it is', async () => {
  await page.evaluate(() => (document.querySelector('main h1').title = 'the block is not loaded'));
  assert.deepEqual(await english(page), ['the block is not loaded']);
});

test('projects: examples, wizard, refusals', async () => {
  await see('projects');
  await until(async () => (await page.locator('.examples li').count()) > 30, 'the examples');
  await german();
  await page.getByRole('button', { name: 'Neues Projekt …' }).click();
  const options = () => page.locator('#wizard-template option').allInnerTexts();
  await until(async () => (await options()).includes('OB 1, OB 100, Fehler-OBs'), 'the templates');
  await page.getByLabel('Projektname').fill('../x');
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await page.locator('.message.problem').filter({ hasText: 'P1317' }).waitFor();
  await german();
});

for (const view of ['io', 'variables', 'symbols', 'hardware', 'process', 'trends', 'program', 'diagnosis'])
  test(`${view} in RUN`, async () => {
    await see(view);
    await turn(page, 'RUN-P');
    await german();
  });

test('hardware: properties and faults of each module', async () => {
  await see('hardware');
  const modules = page.locator('main button[aria-pressed]');
  await until(async () => (await modules.count()) > 5, 'the modules');
  for (let i = 0; i < (await modules.count()); ++i) {
    await modules.nth(i).click();
    await german();
  }
});

test('hardware: the configuration with its catalogue and parameters', async () => {
  await see('hardware');
  await page.getByRole('tab', { name: 'Konfigurieren' }).click();
  await page.getByRole('heading', { name: 'Katalog' }).waitFor();
  await german();
});

test('operands that do not exist', async () => {
  await see('variables');
  for (const operand of ['EW 99999', 'Unsinn', 'M 1.9']) {
    await page.locator('tbody tr').last().locator('input').first().fill(operand);
    await page.keyboard.press('Tab');
    await page.locator(`tr[data-operand='${operand}'] .problem`).waitFor();
  }
  await german();
  await see('trends');
  await page.getByRole('combobox', { name: /Operand/ }).fill('MW 99999');
  await page.keyboard.press('Enter');
  await page.locator('form .problem').filter({ hasText: /./ }).waitFor();
  await german();
});

test('a symbol against the rules', async () => {
  await see('symbols');
  await page.getByLabel('Operand 1', { exact: true }).fill('LW 2');
  await page.getByLabel('Datentyp 2', { exact: true }).fill('REAL');
  await until(async () => (await page.locator('.state li').count()) > 1, 'problems');
  await german();
});

test('a CPU in STOP: reason, buffer with its help, stacks, information', async () => {
  await see('variables');
  const reason = page.locator('aside a[href="#/diagnosis"]');
  await page.locator('tbody tr').last().locator('input').first().fill('M 20.0');
  await page.keyboard.press('Tab');
  await page.locator("tr[data-operand='M 20.0'] .modify input").fill('1');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await page.locator('[data-mode="STOP"]').waitFor();
  const why = /^STOP durch Programmierfehler .*Datenbaustein nicht geladen: DB 99/;
  await until(async () => why.test(await reason.innerText()), 'the reason');
  await see('diagnosis');
  const entries = page.getByRole('table').locator('tbody button');
  await until(async () => (await entries.count()) > 3, 'entries');
  for (let i = 0; i < (await entries.count()); ++i) {
    await entries.nth(i).click();
    await german();
  }
  for (const tab of ['Stacks', 'Baugruppenzustand']) {
    await page.getByRole('tab', { name: tab }).click();
    await german();
  }
});

test('what the CPU refuses', async () => {
  await see('projects');
  await turn(page, 'STOP');
  await turn(page, 'RUN');
  await page.getByRole('button', { name: 'In die CPU laden' }).click();
  await page.locator('.message.problem').first().waitFor();
  await german();
});

test('problems of the compiler, all that the conformance programs make', async () => {
  rmSync(join(server.project, 'haupt.awl'));
  await see('program');
  const told = new Set();
  for (const [name, text] of refusedSources()) {
    const path = join(server.project, name);
    writeFileSync(path, text, 'latin1');
    await page.locator('#program-panel .place', { hasText: name }).first().waitFor();
    await german('#program-panel');
    for (const code of await page.locator('#program-panel .code').allInnerTexts()) told.add(code);
    rmSync(path);
  }
  assert.ok(told.size > 80, `${told.size} codes`);
});
