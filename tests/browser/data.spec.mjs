// The data view of a data block: what its variables begin with and have, folded, live, modified, taken over (S7-MGR-16).
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { replaceAll, text, toLine } from './editor.mjs';
import { expect, launch, message, open, scratch, turn, until, visit, write } from './harness.mjs';
import { crowding } from './layout.mjs';

const PROGRAM = `TYPE "Drive"
  STRUCT
    Speed : REAL ;
    Ramp : STRUCT
      Up : TIME ;
    END_STRUCT ;
  END_STRUCT ;
END_TYPE
TYPE UDT 2
  STRUCT
    Left : "Drive" ;
    Axes : ARRAY [1..2] OF "Drive" ;
  END_STRUCT ;
END_TYPE
FUNCTION_BLOCK FB 1
VAR_INPUT
  Start : BOOL ;
END_VAR
VAR
  Count : INT := 3 ;  // pieces
  When : DATE_AND_TIME := DT#2026-11-28-12:30:45.123 ;
END_VAR
BEGIN
END_FUNCTION_BLOCK
TYPE UDT 3
  STRUCT
    Width : INT ;
  END_STRUCT ;
END_TYPE
DATA_BLOCK DB 1 FB 1 // of the press
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2
  STRUCT
    Speed : REAL := 1.5 ;
    Recipe : STRUCT
      Name : STRING [8] := 'pale' ;
      Step : ARRAY [1..1000] OF INT ;
    END_STRUCT ;
    Run : BOOL ;
  END_STRUCT ;
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 3
  STRUCT
    Machine : UDT 2 ;
  END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     DB2.DBW 20;
      T     MW 10;
END_ORGANIZATION_BLOCK
`;

const workspace = scratch();
const project = join(workspace, 'data');
mkdirSync(project);
writeFileSync(join(project, 'merker.toml'), '[project]\nname = "Data"\n');
writeFileSync(join(project, 'main.awl'), PROGRAM);
writeFileSync(join(project, 'main.sym'), 'Drive  UDT 1  UDT 1  // of an axis\n');
const server = await launch(project, workspace);
const page = await open(server, 'program');
const row = (path) => page.locator(`tr[data-path='${path}']`);
const actual = (path) => row(path).locator('.actual').innerText();
const block = (id) => page.getByRole('treeitem', { name: new RegExp(`^${id}\\b`) });
const folded = (path) => row(path).getByRole('button');

test('a data block as its variables, structures folded', async () => {
  await turn(page, 'RUN-P');
  await block('DB 2').click();
  await page.getByRole('button', { name: 'Datensicht' }).press('Enter');
  await expect(async () => (await page.locator('tr[data-path]').count()), 3);
  await expect(() => actual('Speed'), '1.500000e+000');
  assert.match(await row('Speed').innerText(), /^0\.0\s+Speed\s+REAL\s+1\.500000e\+000/);
  await folded('Recipe').press('Enter');
  assert.match(await row('Recipe.Step').innerText(), /ARRAY\[1\.\.1000\] OF INT/);
  await expect(() => folded('Recipe').getAttribute('aria-expanded'), 'true');
  await expect(() => actual('Recipe.Name'), "'pale'");
  await accessible(page, 'data view');
});

test('a thousand elements are a few rows of the page; the last one is reached', async () => {
  await folded('Recipe.Step').press('Enter');
  await row('Recipe.Step[1]').waitFor();
  const there = await page.locator('tr[data-path]').count();
  assert.ok(there < 120, `${there} rows`);
  await page.locator('.data .frame').evaluate((frame) => frame.scrollTo(0, frame.scrollHeight));
  await row('Recipe.Step[1000]').waitFor();
  await row('Run').waitFor();
  await page.locator('.data .frame').evaluate((frame) => frame.scrollTo(0, 0));
  await row('Speed').waitFor();
});

test('values are those of the CPU, and are modified by name', async () => {
  await write(page, { 'DB2.DBW 20': 77 });
  const field = row('Recipe.Step[2]').getByLabel('Steuerwert von Recipe.Step[2]');
  const at = await row('Recipe.Step[5]').locator('td').first().innerText();
  assert.equal(at, '22.0');
  await expect(() => actual('Recipe.Step[4]'), '77');
  await field.fill('-5');
  await field.press('ArrowDown');
  await page.keyboard.type('6');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await expect(() => actual('Recipe.Step[2]'), '-5');
  await expect(() => actual('Recipe.Step[3]'), '6');
  await field.fill('40000');
  await field.press('Enter');
  await message(page, /40000/);
});

test('actual values become those that the block begins with', async () => {
  await page.getByRole('button', { name: 'Aktualwerte übernehmen' }).press('Enter');
  await message(page, /DB 2: 3 Aktualwerte/);
  await until(async () => /BEGIN\n\s+Recipe\.Step\[2\] := -5;\n\s+Recipe\.Step\[3\] := 6;\n\s+Recipe\.Step\[4\] := 77;\nEND_DATA_BLOCK/.test(await text(page)), 'BEGIN');
  // The keyboard is still at the button of the data view.
  await page.keyboard.press('Control+s');
  await until(() => readFileSync(join(project, 'main.awl'), 'utf-8').includes('Recipe.Step[2] := -5;'), 'the file');
});

test('a value that no constant says keeps its initial value, and is named', async () => {
  await block('DB 1').click();
  await expect(() => actual('When'), 'DT#2026-11-28-12:30:45.123');
  await write(page, { 'DB1.DBW 2': '8', 'DB1.DBW 4': 'W#16#FFFF' });
  await until(async () => (await actual('When')).startsWith('16#FFFF'), 'bytes that are no date');
  await page.getByRole('button', { name: 'Aktualwerte übernehmen' }).press('Enter');
  await message(page, /DB 1: When behält seinen Anfangswert/);
  await until(async () => /Count := 8;/.test(await text(page)), 'BEGIN');
  assert.doesNotMatch(await text(page), /When := /);
});

test('an instance shows what its parameters are; the source comes back', async () => {
  await block('DB 1').click();
  await expect(() => actual('Count'), '8');
  assert.match(await row('Count').innerText(), /STAT[^]*pieces/);
  assert.match(await row('Start').innerText(), /IN\s[^]*FALSE\s+FALSE/);
  await page.locator('.data').getByText('Instanz von FB 1').waitFor();
  const edge = await page.locator('.data .frame').boundingBox();
  const field = await row('When').getByRole('textbox').boundingBox();
  assert.ok(field.x + field.width <= edge.x + edge.width, 'a date leaves the field beside it in sight');
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await page.locator('.code').waitFor();
});

test('a structure of a data type is named as it, in the project and in the CPU', async () => {
  const type = (path) => row(path).locator('td').nth(2).innerText();
  await page.getByRole('button', { name: 'Datensicht' }).click();
  for (const side of ['Offline', 'Online']) {
    await page.getByRole('tab', { name: side }).click();
    await block('DB 3').click();
    for (const path of ['Machine', 'Machine.Left', 'Machine.Axes', 'Machine.Axes[2]'])
      if ((await folded(path).getAttribute('aria-expanded')) === 'false') await folded(path).press('Enter');
    await expect(() => type('Machine'), 'UDT 2');
    await expect(() => type('Machine.Left'), '"Drive"');
    await expect(() => type('Machine.Axes'), 'ARRAY[1..2] OF "Drive"');
    await expect(() => type('Machine.Axes[2]'), '"Drive"');
    await expect(() => type('Machine.Axes[2].Ramp'), 'STRUCT');
  }
  await page.getByRole('tab', { name: 'Offline' }).click();
  await block('DB 3').click();
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await page.locator('.code').waitFor();
});

test('the list marks the block whose data are shown', async () => {
  const marked = () => page.getByRole('treeitem', { selected: true }).innerText();
  const source = readFileSync(join(project, 'main.awl'), 'utf-8');
  const lineOf = (words) => source.split('\n').findIndex((one) => one.startsWith(words)) + 1;
  for (const id of ['OB 1', 'DB 2', 'DB 1']) {
    await visit(page, server, `program?file=main.awl&line=${lineOf(`${id.startsWith('OB') ? 'ORGANIZATION' : 'DATA'}_BLOCK ${id}`) + 1}`);
    await until(async () => (await marked()).startsWith(id), `${id} marked`);
  }
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await page.getByText('Instanz von FB 1').waitFor();
  await visit(page, server, `program?file=main.awl&line=${lineOf('DATA_BLOCK DB 2') + 1}`);
  await until(async () => (await marked()).startsWith('DB 2') && (await row('Speed').count()) === 1, 'DB 2 marked with its data');
  await page.getByRole('button', { name: 'Datensicht' }).click();
});

test('beside KOP and FUP a data block has its data view, a type its declaration; on paper too', async () => {
  const printed = async () => {
    await page.emulateMedia({ media: 'print' });
    const said = await page.locator('.on-paper').innerText();
    await page.emulateMedia({ media: null });
    return said;
  };
  for (const view of ['KOP', 'FUP']) {
    await block('OB 1').click();
    await page.getByRole('button', { name: view, exact: true }).click();
    await page.locator('[data-network="1"]').waitFor();
    await block('DB 2').click();
    await expect(() => actual('Speed'), '1.500000e+000');
    assert.equal(await page.locator('.networks').count(), 0);
    assert.match(await printed(), /^Daten von DB 2[^]*Speed/);
    await block('UDT 3').click();
    await until(async () => (await page.locator('.code .cm-activeLine').innerText().catch(() => '')).startsWith('TYPE UDT 3'), 'the type');
    assert.match(await printed(), /UDT 3[^]*Width : INT/);
  }
  await block('OB 1').click();
  await page.locator('[data-network="1"]').waitFor();
  await page.getByRole('button', { name: 'AWL', exact: true }).click();
});

test('a cursor that comes into a data block by keys or with a selection stays in the text', async () => {
  const isText = async () => (await page.locator('.code').isVisible()) && (await page.locator('.data').count()) === 0;
  const source = await text(page);
  const line = source.split('\n').findIndex((one) => one.startsWith('ORGANIZATION_BLOCK')) + 1;
  await block('DB 2').click();
  await page.getByRole('button', { name: 'Datensicht' }).click();
  await page.locator('.data').waitFor();
  for (const view of ['AWL', 'KOP']) {
    if (view === 'KOP') await page.getByRole('button', { name: view, exact: true }).click();
    await block(view === 'KOP' ? 'UDT 3' : 'OB 1').click();
    await until(isText, `the text beside ${view}`);
    // From the type down into DB 1, from OB 1 up into DB 3.
    for (let i = 0; i < 6; i++) await page.keyboard.press(view === 'KOP' ? 'ArrowDown' : 'ArrowUp');
    await page.getByRole('treeitem', { selected: true, name: view === 'KOP' ? 'DB 1' : 'DB 3' }).first().waitFor();
    assert.ok(await isText(), `${view}: the cursor took the text away`);
    await page.keyboard.type('// typed here');
    await until(async () => (await text(page)).includes('// typed here'), 'what is typed');
    await page.keyboard.press('Control+z');
    await expect(() => text(page), source);
  }
  await page.getByRole('button', { name: 'AWL', exact: true }).click();
  // The button opens the block of the cursor.
  await toLine(page, line - 3);
  const shown = page.getByRole('button', { name: 'Datensicht' });
  await expect(() => shown.getAttribute('aria-pressed'), 'false');
  await shown.press('Enter');
  await row('Machine').waitFor();
  await shown.press('Enter');
  await until(isText, 'the text');
  // A text that ends with a data block.
  const last = source.replace(/ORGANIZATION_BLOCK[^]*/, '');
  await page.keyboard.press('Control+a');
  await replaceAll(page, last);
  await page.keyboard.press('Control+a');
  assert.ok(await isText(), 'what is selected took the text away');
  await replaceAll(page, source);
});

test('a block of the CPU is shown so', async () => {
  await page.getByRole('tab', { name: 'Online' }).click();
  await block('DB 2').click();
  await expect(() => actual('Speed'), '1.500000e+000');
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    let found;
    await until(async () => (found = await crowding(page)).length === 0, () => found.join('\n'));
    await accessible(page, `data view at ${width}`);
  }
});
