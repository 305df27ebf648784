// Import by dropping and choosing files, download as a zip, machine code beside the source.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { content, text, toLine } from './editor.mjs';
import { expect, leave, message, open, quiet, root, scratch, serve, until, visit } from './harness.mjs';

const merker = resolve(process.env.MERKER ?? join(root, 'build/release/merker'));
const files = scratch();
// What is sent lies here for a while, and only here.
const temporary = scratch();
process.env.TMPDIR = temporary;
const server = await serve('sorting-plant');
const page = await open(server, 'projects', { width: 1280, height: 720 });
const english = await open(server, 'projects', { language: 'en' });
const dialog = (of) => of.getByRole('dialog');
const project = (of) => of.locator('.root > strong').innerText();
const uploads = () => readdirSync(temporary).filter((name) => name.startsWith('merker-import-'));
const below = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(folder.length + 1))
    .sort();

/** The PLC of the other page runs. */
const take = () => page.getByRole('dialog', { name: 'Projekt wechseln' }).getByRole('button', { name: 'Wechseln' }).click();

/** As if somebody dropped these files of the disk on the page. */
async function drop(of, ...paths) {
  const list = paths.map((path) => ({ name: path.split('/').at(-1), data: readFileSync(path).toString('base64') }));
  await of.evaluate((list) => {
    const data = new DataTransfer();
    for (const { name, data: text } of list)
      data.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
    for (const kind of ['dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
  }, list);
}

function file(name, text) {
  const path = join(files, name);
  writeFileSync(path, text);
  return path;
}

const source = 'FUNCTION FC 77 : VOID\nBEGIN\nNETWORK\n      U     E 0.0;\n      =     M 99.0;\nEND_FUNCTION\n';
const zip = join(files, 'plant.zip');

test('the project is downloaded as a zip with the files of its folder', async () => {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Als Zip herunterladen' }).click(),
  ]);
  assert.equal(download.suggestedFilename(), 'sorting-plant.zip');
  await download.saveAs(zip);
  await message(page, 'sorting-plant.zip heruntergeladen');
  const to = join(files, 'unpacked');
  mkdirSync(to);
  execFileSync('python3', ['-m', 'zipfile', '-e', zip, to]);
  assert.deepEqual(below(to), below(server.project));
  for (const name of below(to)) assert.deepEqual(readFileSync(join(to, name)), readFileSync(join(server.project, name)), name);
});

test('a zip that is dropped becomes a new project, which can be opened', async () => {
  await drop(page, zip);
  await dialog(page).getByText('Gefunden: plant').waitFor();
  await expect(() => dialog(page).getByLabel('Neues Projekt').inputValue(), 'plant');
  await accessible(page, 'import');
  await dialog(page).getByRole('button', { name: 'Importieren', exact: true }).click();
  await dialog(page).getByText('Alles ist importiert.').waitFor();
  await dialog(page).getByText(/Dateien eines Merker-Projekts, unverändert/).waitFor();
  await accessible(page, 'report');
  const folder = join(server.workspace, 'merker', 'plant');
  assert.deepEqual(below(folder).filter((name) => name !== 'import-report.txt'), below(server.project));
  await dialog(page).getByRole('button', { name: 'plant öffnen' }).click();
  await take();
  await until(async () => (await page.locator('.folder').innerText()).endsWith('/merker/plant'), 'the new folder');
  await expect(() => project(page), 'Sorting plant');
  await until(() => uploads().length === 0, 'no file that was sent');
});

test('a source that is chosen goes into the open project, and replaces no file', async () => {
  const [chooser] = await Promise.all([
    english.waitForEvent('filechooser'),
    english.getByRole('button', { name: 'Import …' }).click(),
  ]);
  await chooser.setFiles([file('motor.awl', source), file('symbols.sdf', '"Neu                     ","M      99.0","BOOL      ","new"\r\n')]);
  await dialog(english).getByRole('radio', { name: /^Into the open project "Sorting plant"/, checked: true }).waitFor();
  await dialog(english).getByRole('button', { name: 'Import', exact: true }).click();
  await dialog(english).getByText('New files: motor.awl, symbols.sdf').waitFor();
  const folder = join(server.workspace, 'merker', 'plant');
  assert.equal(readFileSync(join(folder, 'motor.awl'), 'utf-8'), source);
  await dialog(english).getByRole('button', { name: 'Close', exact: true }).last().click();
  await drop(english, file('motor.awl', '// another text\n' + source));
  await dialog(english).getByRole('button', { name: 'Import', exact: true }).click();
  await dialog(english).getByText('motor.awl exists in the project; it was not replaced').waitFor();
  await dialog(english).getByText('A part was not imported.').waitFor();
  assert.equal(readFileSync(join(folder, 'motor.awl'), 'utf-8'), source);
  await leave(english);
});

test('what merker export writes comes back: blocks of STEP 7, a program of STEP 5', async () => {
  const run = (...options) => execFileSync(merker, options, { cwd: files });
  run('export', server.project, '-o', 'blocks.wld');
  await drop(page, join(files, 'blocks.wld'));
  await dialog(page).getByRole('radio', { name: 'Neues Projekt' }).check();
  await dialog(page).getByLabel('Name').fill('Bausteine');
  await dialog(page).getByRole('button', { name: 'Importieren', exact: true }).click();
  await dialog(page).locator('[data-effect="came"]').getByText(/Bausteinen mit eigener Quelle/).waitFor();
  assert.ok(existsSync(join(server.workspace, 'merker', 'Bausteine', 'OB1.awl')));
  await leave(page);
  run('export', join(root, 'examples/step5/symbols/pump.s5'), '-o', 'PUMPEST.S5D');
  const made = readdirSync(files).filter((name) => /S5D$|SEQ$/.test(name));
  await drop(page, ...made.map((name) => join(files, name)));
  await dialog(page).getByLabel('Neues Projekt').fill('Pumpe');
  await dialog(page).getByLabel('Zeichensatz der Texte').selectOption('850');
  await dialog(page).getByRole('button', { name: 'Importieren', exact: true }).click();
  await dialog(page).getByText(/STEP-5-Bausteine als Listen/).waitFor();
  await dialog(page).getByText('die Zeichen sind die der Codepage 850').waitFor();
  await dialog(page).getByRole('button', { name: 'Pumpe öffnen' }).click();
  await take();
  await page.locator('.root').getByText('SINUMERIK').first().waitFor();
  await until(() => uploads().length === 0, 'no file that was sent');
});

test('the machine code of a listing stands beside it, in words', async () => {
  await visit(page, server, 'program');
  await until(async () => /\bBE\b/.test(await content(page).innerText()), 'a listing');
  const line = (await text(page)).split('\n').findIndex((one) => /\bSPA\b/.test(one)) + 1;
  await toLine(page, line);
  await page.getByRole('tab', { name: 'Maschinencode' }).click();
  const table = page.getByRole('table', { name: /^Maschinencode von / });
  await table.locator('th', { hasText: 'Wort' }).waitFor();
  const here = table.locator('tr.here').first();
  await until(async () => Number(await here.getByRole('button').innerText()) === line, 'the line of the cursor');
  assert.match(await here.locator('td').nth(1).innerText(), /^[0-9A-F]{4}( [0-9A-F]{4})*$/);
  assert.match(await here.locator('td').nth(2).innerText(), /^SPA\s+PB 5$/);
});

test('what nobody knows is refused with the reason', async () => {
  await quiet(page);
  await drop(page, file('letter.txt', 'Dear reader'));
  await message(page, 'darin ist nichts, was sich importieren lässt');
  await expect(() => dialog(page).count(), 0);
});

test('an import that is cancelled leaves nothing', async () => {
  await quiet(page);
  await drop(page, zip);
  await dialog(page).getByLabel('Neues Projekt').fill('cancelled');
  assert.equal(uploads().length, 1);
  await leave(page);
  await until(() => uploads().length === 0, 'no file that was sent');
  assert.ok(!existsSync(join(server.workspace, 'merker', 'cancelled')));
});

test('the machine code of a source stands beside it, in bytes', async () => {
  await visit(english, server, 'projects');
  await english.getByRole('button', { name: 'Open folder …' }).click();
  await english.locator('#folder').fill('plant');
  await dialog(english).getByRole('button', { name: 'Open', exact: true }).click();
  await english.getByRole('dialog', { name: 'Change the project' }).getByRole('button', { name: 'Change' }).click();
  await expect(() => project(english), 'Sorting plant');
  await visit(english, server, 'program?block=OB%201');
  await english.getByRole('tab', { name: 'Machine code' }).click();
  const table = english.getByRole('table', { name: 'Machine code of OB 1' });
  await table.locator('th', { hasText: 'Byte' }).waitFor();
  await table.locator('th', { hasText: 'Source' }).waitFor();
  const first = table.locator('tbody tr').first();
  const line = Number(await first.getByRole('button').innerText());
  const folder = join(server.workspace, 'merker', 'plant');
  const sources = below(folder).filter((name) => name.endsWith('.awl')).map((name) => readFileSync(join(folder, name), 'utf-8'));
  const shown = (await first.locator('.source').innerText()).trim();
  assert.ok(sources.some((one) => one.split('\n')[line - 1]?.trim() === shown), `line ${line}: ${shown}`);
});

test('each file that was dropped has its line; the code page can be chosen', async () => {
  const folder = join(server.workspace, 'merker', 'plant');
  const greek = join(files, 'greek.awl');
  writeFileSync(greek, Buffer.from('// \xC8\n' + source.replace('77', '79'), 'latin1'));
  await quiet(page);
  await drop(page, greek, file('Start.scn', '0s: E 0.0 = 1\n'), file('watch.vat', 'MW 20\n'), file('manual.pdf', '%PDF-1.4'));
  await dialog(page).getByLabel('Zeichensatz der Texte').selectOption('1253');
  await accessible(page, 'code page');
  await dialog(page).getByRole('button', { name: 'Importieren', exact: true }).click();
  await dialog(page).getByText('Neue Dateien: Start.scn, greek.awl, watch.vat').waitFor();
  await dialog(page).locator('[data-effect="beside"]').getByText('manual.pdf lässt sich nicht importieren').waitFor();
  assert.match(readFileSync(join(folder, 'greek.awl'), 'utf-8'), /^\/\/ Θ\n/);
  await leave(page);
});

test('what is not in the zip is named until somebody has read it', async () => {
  const folder = join(server.workspace, 'merker', 'plant');
  mkdirSync(join(folder, 'part'));
  writeFileSync(join(folder, 'part', 'merker.toml'), '');
  await visit(page, server, 'projects');
  await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Als Zip herunterladen' }).click()]);
  await message(page, 'plant.zip heruntergeladen. Nicht im Zip: part/');
});

test('a data block shows its variables with their values', async () => {
  await visit(page, server, 'program?block=DB%2011');
  await page.getByRole('tab', { name: 'Maschinencode' }).click();
  const table = page.getByRole('table', { name: 'Maschinencode von DB 11' });
  await table.locator('th', { hasText: 'Aktualwert' }).waitFor();
  assert.match(await table.locator('tbody tr').first().innerText(), /DB[XBWD] 0/);
});

test('a connection that is lost is told, and the import has ended', async () => {
  const other = await serve('sorting-plant');
  const here = await open(other, 'projects', { width: 390, height: 844 });
  await drop(here, file('lost.awl', source));
  await dialog(here).getByRole('radio', { name: 'Neues Projekt' }).check();
  await other.close();
  await message(here, 'Die Verbindung ist abgebrochen. Es wurde nichts importiert');
  await expect(() => dialog(here).count(), 0);
  await here.close(); // it tries again for ever
  here.complaints.length = 0; // the browser itself logs each failed try
});
