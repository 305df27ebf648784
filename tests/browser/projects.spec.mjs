// Projects: tree, examples, wizard, folders, compare, load, upload (S7-MGR-01 to S7-MGR-11, S7-MGR-15).
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, leave, message, open, picture, quiet, serve, turn, until } from './harness.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'projects');
const name = () => page.locator('.root > strong').innerText();

test('the project is a tree of station, CPU, program, and each entry opens its tool (S7-MGR-03)', async () => {
  await expect(name, 'Sorting plant');
  for (const entry of ['MPI(1)', 'SIMATIC 300(1)', 'Hardware', 'CPU 314C-2 PtP', 'S7-Programm(1)', 'Quellen', 'Bausteine', 'Symbole'])
    await until(async () => (await page.locator('.root').innerText()).includes(entry), entry);
  await page.locator('.root').getByRole('link', { name: 'Symbole' }).click();
  await page.getByRole('heading', { name: 'Symbole' }).waitFor();
  await page.goBack();
});

test('Hardware opens the configuration of this station (S7-MGR-05)', async () => {
  await page.locator('.root').getByRole('link', { name: 'Hardware' }).click();
  await page.getByRole('tab', { name: 'Konfigurieren', selected: true }).waitFor();
  await page.getByRole('button', { name: /^Steckplatz 2: CPU 314C-2 PtP/ }).waitFor();
  await page.goBack();
});

test('insert a block, symbols, editor, transfer, simulator: each from here (S7-MGR-09)', async () => {
  await page.getByRole('button', { name: 'In die CPU laden' }).waitFor();
  await page.locator('.root').getByRole('link', { name: 'Symbole' }).waitFor();
  await page.locator('.root').getByRole('link', { name: 'Quellen' }).click();
  await page.locator('.code .cm-content').waitFor();
  await page.getByRole('button', { name: 'Neuer Baustein' }).waitFor();
  await page.locator('header nav').getByRole('link', { name: 'E/A' }).click();
  await page.locator('#tile-operand').waitFor();
  await page.goto(page.url().replace(/#.*/, '#/projects'));
});

test('project and CPU are compared block by block (S7-MGR-15)', async () => {
  await page.getByText('Projekt und CPU sind gleich.').waitFor();
  await picture(page, 'projects');
});

test('what a dialog is refused stands in it and can be closed', async () => {
  await page.getByRole('button', { name: 'Neues Projekt …' }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByLabel('Projektname').fill('Größe "A" 1/2');
  await page.keyboard.press('Enter');
  await dialog.getByRole('alert').waitFor();
  await accessible(page, 'refused in a dialog');
  await dialog.getByRole('alert').getByRole('button').click();
  await expect(() => page.getByRole('alert').count(), 0);
  await leave(page);
});

test('an example is opened as a copy', async () => {
  const before = server.project;
  await page.getByRole('searchbox').fill('traffic');
  await page.getByRole('button', { name: /^Öffnen: / }).first().click();
  await until(async () => (await name()) !== 'Sorting plant', 'another project');
  assert.ok(existsSync(join(before, 'merker.toml')));
});

test('the wizard makes a project with CPU, MPI address, OB 1 and representation (S7-MGR-01)', async () => {
  await page.getByRole('button', { name: 'Neues Projekt …' }).click();
  await page.getByLabel('Projektname').fill('Manfred');
  await page.getByLabel('CPU-Typ').selectOption('314C-2 PtP');
  await expect(() => page.getByLabel('MPI-Adresse').inputValue(), '2');
  await page.getByLabel('MPI-Adresse').fill('5');
  await expect(() => page.getByLabel('Einsprung-OB').inputValue(), 'OB 1');
  await expect(async () => (await page.getByLabel('Darstellung').locator('option').allInnerTexts()).join(' | '),
    'AWL, deutsche Mnemonik | AWL, internationale Mnemonik | KOP | FUP');
  await page.getByLabel('Darstellung').selectOption('german');
  await picture(page, 'projects-wizard');
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await page.locator('.path', { hasText: 'main.awl' }).first().waitFor();
  await page.goto(page.url().replace(/#.*/, '#/projects'));
  await expect(name, 'Manfred');
  const made = (file) => readFileSync(join(server.workspace, 'merker', 'Manfred', file), 'utf-8');
  assert.match(made('merker.toml'), /model = "314C-2 PtP"\nmpi_address = 5/);
  assert.match(made('main.awl'), /^ORGANIZATION_BLOCK OB 1$/m);
  // A CPU that has never run has no cycle times.
  const times = page.locator('aside dl').first().locator('dd');
  await expect(async () => (await times.allInnerTexts()).join(' '), '– – – 0');
});

test('MPI(1) shows who is on it (S7-MGR-04)', async () => {
  await page.getByRole('button', { name: 'MPI(1), Adresse 5' }).click();
  const rows = page.getByRole('dialog').getByRole('table').locator('tbody tr');
  await expect(() => rows.count(), 2);
  await until(async () => /PG.*\s0$/s.test(await rows.nth(0).innerText()), 'the PG');
  await until(async () => /CPU 314C-2 PtP\s+5$/.test(await rows.nth(1).innerText()), 'the CPU');
  await picture(page, 'projects-mpi');
  await leave(page);
});

test('a folder below the workspace is opened again, others are refused', async () => {
  await quiet(page);
  await page.getByRole('button', { name: 'Ordner öffnen …' }).click();
  await page.locator('#folder').fill('/etc');
  await page.getByRole('dialog').getByRole('button', { name: 'Öffnen', exact: true }).click();
  await message(page, 'P1318');
  await page.locator('#folder').fill(server.project);
  await page.getByRole('dialog').getByRole('button', { name: 'Öffnen', exact: true }).click();
  await expect(name, 'Sorting plant');
});

test('the project of the command line and those of the workspace are in the list of folders', async () => {
  await page.getByRole('button', { name: 'Ordner öffnen …' }).click();
  const dialog = page.getByRole('dialog');
  const names = (list) => dialog.getByRole('list', { name: list }).getByRole('listitem').allInnerTexts();
  await until(async () => (await names('Im Arbeitsordner')).includes('Manfred'), 'Manfred');
  assert.ok((await names('Zuletzt geöffnet')).includes(server.project), 'the way back');
  await accessible(page, 'folders');
  await dialog.getByRole('list', { name: 'Im Arbeitsordner' }).getByRole('button', { name: 'Manfred' }).press('Enter');
  await expect(name, 'Manfred');
});

test('an example that was changed is opened again as it was', async () => {
  const changed = join(server.workspace, 'merker', 'traffic-light', 'merker.toml');
  writeFileSync(changed, `${readFileSync(changed, 'utf-8')}# mine\n`);
  await page.getByRole('searchbox').fill('traffic');
  await page.getByRole('button', { name: /^Neue Kopie: / }).first().press('Enter');
  await until(async () => (await page.locator('.folder').innerText()).endsWith('/traffic-light 2'), 'the new copy');
  assert.doesNotMatch(readFileSync(join(server.workspace, 'merker', 'traffic-light 2', 'merker.toml'), 'utf-8'), /# mine/);
  assert.match(readFileSync(changed, 'utf-8'), /# mine/);
});

test('the project is copied into a folder of its own', async () => {
  await page.getByRole('button', { name: 'Kopieren …' }).press('Enter');
  const dialog = page.getByRole('dialog');
  await expect(() => dialog.getByLabel('Projektname').inputValue(), 'traffic-light 2 Kopie');
  await dialog.getByLabel('Projektname').fill('Manfred');
  await page.keyboard.press('Enter');
  await message(page, 'P1312');
  await dialog.getByLabel('Projektname').fill('Kreuzung');
  await dialog.getByLabel('Die Kopie öffnen').press('Space');
  await accessible(page, 'copy');
  await dialog.getByLabel('Projektname').press('Enter');
  await until(async () => (await page.locator('.folder').innerText()).endsWith('/Kreuzung'), 'the copy');
  await expect(() => dialog.count(), 0);
});

test('a running PLC is not taken from another page without a question, and that page is told', async () => {
  await turn(page, 'RUN-P');
  const other = await open(server, 'io');
  await page.getByRole('searchbox').fill('lift');
  const wish = page.getByRole('button', { name: /^Öffnen: Aufzug/ });
  const question = page.getByRole('dialog', { name: 'Projekt wechseln' });
  await wish.click();
  await question.getByText('und 1 weitere Seite arbeitet damit.').waitFor();
  await accessible(page, 'question');
  await question.getByRole('button', { name: 'Abbrechen' }).press('Enter');
  await expect(() => question.count(), 0);
  assert.ok((await page.locator('.folder').innerText()).endsWith('/Kreuzung'));
  await wish.click();
  await question.getByRole('button', { name: 'Wechseln' }).press('Enter');
  await until(async () => (await page.locator('.folder').innerText()).endsWith('/lift'), 'the lift');
  await message(other, /Eine andere Seite hat das Projekt .* geöffnet/);
  await expect(() => other.locator('.message').filter({ hasText: /Erledigt: *Eine andere Seite/ }).count(), 0);
  await expect(() => page.locator('.message').filter({ hasText: 'Eine andere Seite' }).count(), 0);
  // In STOP nothing is taken from anybody.
  await turn(page, 'STOP');
  await page.getByRole('button', { name: 'Ordner öffnen …' }).click();
  await page.getByRole('dialog').getByRole('list', { name: 'Zuletzt geöffnet' }).getByRole('button', { name: server.project, exact: true }).click();
  await expect(name, 'Sorting plant');
  await other.context().close();
});

test('blocks are uploaded from the CPU as sources (S7-MGR-15)', async () => {
  await turn(page, 'RUN-P');
  await page.getByRole('checkbox', { name: 'FC 1 auswählen' }).check();
  await page.getByRole('button', { name: 'Aus der CPU holen' }).click();
  await message(page, 'Aus der CPU geholt');
  const uploaded = join(server.project, 'online/FC1.awl');
  await until(() => existsSync(uploaded) && /^FUNCTION "Count boxes"/m.test(readFileSync(uploaded, 'utf-8')), uploaded);
});
