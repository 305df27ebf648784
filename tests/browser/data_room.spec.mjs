// The data view of long names, values and comments: everything that is entered and read is in sight on every screen.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, launch, message, open, quiet, scratch, turn, until } from './harness.mjs';
import { crowding } from './layout.mjs';

const PROGRAM = `FUNCTION_BLOCK FB 2
VAR_INPUT
  ReleaseOfTheConveyor : BOOL ;  // release of the whole conveyor
END_VAR
VAR
  StartOfTheLastBatch : DATE_AND_TIME := DT#2026-11-28-12:30:45.123 ;  // when the last batch began
  LongDesignation : STRING [40] := 'a designation that is long enough' ;  // shown at the panel
  Count : INT := 3 ;  // pieces
  Recipe : STRUCT
    Step : ARRAY [1..20] OF DATE_AND_TIME ;
  END_STRUCT ;
END_VAR
BEGIN
END_FUNCTION_BLOCK
DATA_BLOCK DB 20 FB 2
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 21
  STRUCT
    Ratio : REAL := 3.14 ;
    Mask : DWORD := DW#16#12345678 ;
    Last : DATE_AND_TIME := DT#2024-02-29-12:30:45.123 ;
    Label : STRING [80] := 'a text that no column of this table can show, on whatever screen it is' ;
  END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     0;
END_ORGANIZATION_BLOCK
`;

const workspace = scratch();
const project = join(workspace, 'data');
mkdirSync(project);
writeFileSync(join(project, 'merker.toml'), '[project]\nname = "Data"\n');
writeFileSync(join(project, 'main.awl'), PROGRAM);
const server = await launch(project, workspace);
const page = await open(server, 'program');
const row = (path) => page.locator(`tr[data-path='${path}']`);
const actual = (path) => row(path).locator('.actual').innerText();

/** From where to where the heading of a column is, in its frame; null if it is not there. */
const columns = () => page.locator('.data .frame').evaluate((frame) => {
  const { left, right } = frame.getBoundingClientRect();
  const heads = [...frame.querySelectorAll('th')].filter((one) => one.checkVisibility());
  return Object.fromEntries(heads.map((one) => {
    const box = one.getBoundingClientRect();
    return [one.textContent, { wide: Math.round(box.width), inside: box.left >= left - 1 && box.right <= right + 1 }];
  }));
});

test('address, name, actual value, modify value and comment are in sight on every screen', async () => {
  await turn(page, 'RUN-P');
  await page.getByRole('treeitem', { name: /^DB 20\b/ }).click();
  await page.getByRole('button', { name: 'Datensicht' }).press('Enter');
  await expect(() => actual('Count'), '3');
  await page.getByRole('button', { name: 'Alles aufklappen' }).press('Enter');
  await row('Recipe.Step[1]').waitFor();
  assert.match(await row('Recipe').innerText(), /STAT/, 'a structure is declared as well');
  for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) {
    await page.setViewportSize({ width, height });
    let found;
    const good = (name, wide) => found[name]?.inside && found[name].wide >= wide;
    await until(async () => {
      found = await columns();
      return ['Adresse', 'Name', 'Typ', 'Aktualwert'].every((name) => good(name, 40)) && good('Steuerwert', 90) && good('Kommentar', width > 1100 ? 100 : 72);
    }, () => `the columns at ${width}: ${JSON.stringify(found)}`);
    if (width > 1100) assert.ok(found.Deklaration?.inside && found.Anfangswert?.inside, JSON.stringify(found));
    let crowded;
    await until(async () => (crowded = await crowding(page)).length === 0, () => crowded.join('\n'));
    await accessible(page, `data view at ${width}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
});

/** The paths of the rows whose cell of this column ends with dots. */
const cut = (column) => page.locator(`.data td.${column}`).evaluateAll((cells) =>
  cells.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.parentElement.dataset.path));

test('values are whole where there is room; what is cut is read below, by finger and by keyboard', async () => {
  await page.getByRole('treeitem', { name: /^DB 21\b/ }).click();
  await expect(() => actual('Ratio'), '3.140000e+000');
  for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) {
    await page.setViewportSize({ width, height });
    await until(async () => (await cut('actual')).join() === 'Label', async () => `actual values at ${width}, cut: ${await cut('actual')}`);
    const found = await columns();
    assert.ok(found.Anfangswert?.inside, `initial values at ${width}: ${JSON.stringify(found)}`);
    const initial = (await cut('initial')).join();
    assert.equal(initial, width === 1024 ? 'Last,Label' : 'Label', `initial values at ${width}`);
    await row('Last').locator('td').first().click();
    await expect(() => page.locator('.whole').count().then((count) => count > 0), width === 1024);
    if (width === 1024) assert.match(await page.locator('.whole').innerText(), /Last[^]*Anfangswert\s+DT#2024-02-29-12:30:45\.123/);
    await row('Last').getByRole('textbox').focus();
    await page.keyboard.press('ArrowDown');
    await until(async () => /Label[^]*Aktualwert\s+'a text [^]* screen it is'/.test(await page.locator('.whole').innerText()), 'the text below');
    await accessible(page, `data view with a long text at ${width}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.getByRole('treeitem', { name: /^DB 20\b/ }).click();
  await row('Count').waitFor();
});

test('a number that is too large is told with its range; what succeeds later takes the message away', async () => {
  await quiet(page);
  const field = row('Count').getByRole('textbox');
  await field.fill('99999');
  await field.press('Enter');
  await message(page, /DB20\.Count: 99999 liegt außerhalb von INT, -32768 bis 32767/);
  await page.getByRole('button', { name: 'Aktualwerte übernehmen' }).press('Enter');
  await message(page, /in der Quelle/);
  assert.equal(await page.locator('.message.problem').count(), 0);
  await field.fill('7');
  await field.press('Enter');
  await expect(() => actual('Count'), '7');
});

test('a refused modify value is marked in its row with the reason until it is changed', async () => {
  await page.getByRole('treeitem', { name: /^DB 21\b/ }).click();
  const field = (path) => row(path).getByRole('textbox');
  const invalid = (path) => field(path).getAttribute('aria-invalid');
  await field('Ratio').fill('2.5');
  await field('Mask').fill('DW#16#1FFFFFFFF');
  await page.getByRole('button', { name: 'Steuern', exact: true }).press('Enter');
  await expect(() => invalid('Mask'), 'true');
  assert.equal(await invalid('Ratio'), null, 'the other value is good');
  const told = await page.locator(`[id='${await field('Mask').getAttribute('aria-describedby')}']`).textContent();
  assert.match(told, /DW#16#1FFFFFFFF/);
  assert.match(await page.locator('.whole').innerText(), /Mask[^]*▲[^]*DW#16#1FFFFFFFF/);
  await accessible(page, 'a refused modify value');
  await field('Mask').fill('DW#16#1');
  await expect(() => invalid('Mask'), null);
  await field('Mask').press('Enter');
  await expect(() => actual('Mask'), 'DW#16#00000001');
  await page.getByRole('treeitem', { name: /^DB 20\b/ }).click();
  await field('Count').fill('99999');
  await field('Count').press('Enter');
  await expect(() => invalid('Count'), 'true');
  assert.match(await row('Count').locator('.comment').innerText(), /-32768 bis 32767/);
  await quiet(page);
});

test('F1 names the keys as the keyboard of the page does, each apart from its text', async () => {
  await page.keyboard.press('F1');
  const rows = page.locator('dialog .keys li');
  await rows.filter({ hasText: 'Strg' }).first().waitFor();
  assert.equal(await page.locator('dialog kbd', { hasText: 'Ctrl' }).count(), 0);
  const gaps = await rows.evaluateAll((all) => all.map((one) => {
    const [keys, text] = [...one.children].map((child) => child.getBoundingClientRect());
    return text.left - [...one.querySelectorAll('kbd')].at(-1).getBoundingClientRect().right;
  }));
  assert.ok(Math.min(...gaps) >= 8, `${Math.min(...gaps)} px between keys and text`);
});
