// Program status beside the text, breakpoints and single step (S7-EDIT-21, -22).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { content, statusOf, toLine } from './editor.mjs';
import { expect, open, picture, serve, turn, until } from './harness.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'program?file=sorting.awl');
const source = () => content(page).evaluate((element) => (element.cmTile ?? element.cmView).view.state.doc.toString());
const lineOf = async (words) => (await source()).split('\n').findIndex((line) => line.includes(words)) + 1;
const block = (id) => page.getByRole('treeitem').filter({ has: page.locator('.id', { hasText: new RegExp(`^${id}$`) }) }).first();

test('status: VKE, STA and AKKU 1 behind each statement (S7-EDIT-21)', async () => {
  await turn(page, 'RUN-P');
  await block('FB 1').click();
  await page.getByRole('switch', { name: 'Status' }).click();
  const line = await lineOf('UN    #BeamSmall;');
  await toLine(page, line);
  const [vke, sta, akku] = await until(async () => {
    const row = await statusOf(page, line);
    return row.slice(0, 2).every((bit) => /^[01]$/.test(bit)) && row;
  }, 'VKE and STA');
  assert.notEqual(vke, sta, 'UN negates');
  assert.match(akku, /\S/);
  await picture(page, 'program-status');
});

test('of a block called with several instance data blocks one is chosen (S7-EDIT-21)', async () => {
  await block('FB 2').click();
  const list = page.getByRole('combobox', { name: 'Aufrufumgebung' });
  await until(async () => (await list.locator('option').allInnerTexts()).join().startsWith('letzter Aufruf: DB 13'), 'the last call');
  await expect(() => list.locator('option').count(), 4);
  const line = await lineOf('L     #Travel;');
  const travel = (time) => until(async () => time.test((await statusOf(page, line)).join(' ')), `${time}`);
  await toLine(page, line);
  await travel(/S5T#7S|0700$/);
  await list.selectOption({ label: 'DB 11 Small boxes' });
  await travel(/S5T#3S|0300$/);
  // Who looks at another block meanwhile finds the call again.
  await block('OB 1').click();
  await expect(() => list.count(), 0);
  await block('FB 2').click();
  await expect(() => list.locator('option:checked').innerText(), 'DB 11 Small boxes');
  await accessible(page, 'a call environment');
  await list.selectOption({ index: 0 });
  await toLine(page, line);
  await travel(/S5T#7S|0700$/);
  await block('FB 1').click();
});

test('more columns on demand (S7-EDIT-21)', async () => {
  await page.locator('summary', { hasText: 'Spalten' }).click();
  await page.getByRole('checkbox', { name: 'STW' }).check();
  const line = await lineOf('UN    #BeamSmall;');
  await until(async () => (await statusOf(page, line)).length === 4, 'a fourth column');
  await until(async () => /STW/.test(await page.locator('.code .cm-status-head').innerText()), 'its heading');
  await page.locator('summary', { hasText: 'Spalten' }).click();
});

test('the value of an operand stands behind it in the text', async () => {
  await page.locator('summary', { hasText: 'Spalten' }).click();
  const beside = page.getByRole('button', { name: 'Wert am Operanden' });
  await beside.press('Space');
  await toLine(page, await lineOf('"Plant data".TravelMiddle'));
  const shown = () => page.locator('.code .cm-activeLine .cm-operand-value').allInnerTexts();
  await until(async () => (await shown()).includes('S5T#5S'), 'the travel time');
  await toLine(page, await lineOf('UN    #BeamSmall;'));
  await until(async () => /^[01]$/.test((await shown())[0] ?? ''), 'a parameter, as its statement has seen it');
  await toLine(page, await lineOf('L     #Filter;'));
  await until(async () => (await shown()).includes('S5T#50MS'), 'another one, in the form of its type');
  await toLine(page, await lineOf('Pulse := #Small'));
  await until(async () => /^[01]$/.test((await shown())[0] ?? ''), 'the local variable that a CALL was given');
  for (const statement of ['S     #SeenMiddle;', 'FN    #Edge;']) {
    await toLine(page, await lineOf(statement));
    await until(async () => /^[01]$/.test((await shown())[0] ?? ''), `the bit of ${statement}`);
  }
  await accessible(page, 'values in the text');
  await beside.press('Space');
  await expect(() => page.locator('.code .cm-operand-value').count(), 0);
  await page.locator('summary', { hasText: 'Spalten' }).click();
});

test('a changed text has no status until it is loaded', async () => {
  await toLine(page, 1);
  await page.keyboard.insertText('// new\n');
  await page.getByText(/Die CPU hat einen anderen Stand/).waitFor();
  await page.keyboard.press('Control+z');
  await expect(() => page.getByText(/Die CPU hat einen anderen Stand/).count(), 0);
});

test('a breakpoint stops the CPU there: HALT, its line is marked (S7-EDIT-22)', async () => {
  const line = await lineOf('UN    #BeamMiddle;');
  await toLine(page, line);
  await page.keyboard.press('F9');
  await page.locator('[data-mode="HALT"]').waitFor();
  await page.getByText(`HALT in FB 1, Zeile ${line}`).waitFor();
  await until(async () => /BeamMiddle/.test(await page.locator('.code .cm-halt-line').innerText()), 'the line');
  await picture(page, 'program-halt');
});

test('step over goes to the next statement, go on to the breakpoint (S7-EDIT-22)', async () => {
  const line = await lineOf('UN    #BeamMiddle;');
  const register = (name) => page.locator('.halt .registers').getByText(new RegExp(`^${name} [0-9A-F]{4}`)).innerText();
  const before = await register('STW');
  await page.keyboard.press('F10');
  await page.getByText(`HALT in FB 1, Zeile ${line + 1}`).waitFor();
  await page.keyboard.press('F10');
  // S ends the string of logic operations: the first bit of the status word says so.
  await until(async () => (await register('STW')) !== before, 'the registers of the new place');
  await page.keyboard.press('F8');
  await page.getByText(`HALT in FB 1, Zeile ${line}`).waitFor();
});

test('another browser sees the HALT and the breakpoint too', async () => {
  const other = await open(server, 'program', { language: 'en' });
  await other.getByText(/^HALT in FB 1, line/).waitFor();
  await other.locator('.code .cm-point-mark').waitFor();
});

test('a click beside the line clears the breakpoint, the program goes on', async () => {
  await page.locator('.code .cm-point-mark').first().click();
  await expect(() => page.locator('.code .cm-point-mark').count(), 0);
  await page.getByRole('button', { name: /^Fortsetzen/ }).click();
  await page.locator('[data-mode="RUN"]').waitFor();
});
