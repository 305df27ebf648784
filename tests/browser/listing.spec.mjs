// Program status, breakpoints, single steps and stacks of a SINUMERIK, in its listing.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { content, statusOf, text, toLine } from './editor.mjs';
import { expect, launch, open, picture, scratch, serve, turn, until, visit, write } from './harness.mjs';

const server = await serve('step5/tool-changer');
const page = await open(server, 'program?file=main.s5');
const columns = () => page.locator('.code .cm-status-head .cm-status-cell').allInnerTexts();
const haltLine = () => page.locator('.code .cm-halt-line').innerText();
let line; // the first statement of PB 1

test('status: VKE, STA and AKKU 1 beside each statement of the block', async () => {
  await until(async () => (await content(page).innerText()).includes('OB 1'), 'the listing');
  line = (await text(page)).split('\n').findIndex((one) => /^PB 1\b/.test(one)) + 3;
  await turn(page, 'RUN');
  await page.getByRole('switch', { name: 'Status' }).click();
  await toLine(page, line);
  await page.locator('.work .head').getByText('PB 1', { exact: true }).waitFor();
  const [vke, sta, akku] = await until(async () => {
    const row = await statusOf(page, line);
    return row.slice(0, 2).every((bit) => /^[01]$/.test(bit)) && row;
  }, 'VKE and STA');
  assert.deepEqual([vke, sta], ['0', '0'], 'U E 0.0: the emergency stop is pressed');
  assert.match(akku, /^[0-9A-F]+$/);
  // UN M 132.0: no fault, but the chain is 0 already.
  await expect(async () => (await statusOf(page, line + 2)).slice(0, 2).join(' '), '0 0');
});

test('the status follows the input', async () => {
  await visit(page, server, 'io');
  await page.locator('#tile-operand').fill('EB 0');
  await page.locator('#tile-operand').press('Enter');
  const key = page.locator('button[data-operand="E 0.0"]').first();
  await key.click();
  await until(async () => (await key.locator('.lamp').innerText()) === '1', 'E 0.0');
  await visit(page, server, `program?file=main.s5&line=${line}`);
  await expect(async () => (await statusOf(page, line)).slice(0, 2).join(' '), '1 1');
  await expect(async () => (await statusOf(page, line + 1)).slice(0, 2).join(' '), '0 0');
});

test('the value of a formal operand stands behind it, as its statement has seen it', async () => {
  const formal = await serve('step5/09-formal-operands');
  const other = await open(formal, 'program?block=FB 201');
  await turn(other, 'RUN');
  await until(async () => (await content(other).innerText()).includes('=BETR'), 'the listing of FB 201');
  await other.getByRole('switch', { name: 'Status' }).click();
  await other.locator('summary', { hasText: 'Spalten' }).click();
  await other.getByRole('button', { name: 'Wert am Operanden' }).press('Space');
  await toLine(other, (await text(other)).split('\n').findIndex((one) => one.includes('=EIN')) + 1);
  const shown = async () => (await other.locator('.code .cm-activeLine .cm-operand-value').allInnerTexts()).join(' ');
  await expect(shown, '0');
  await write(other, { 'E 20.0': 1 });
  await expect(shown, '1');
  await other.context().close();
});

test('columns of registers that the PLC does not have are not offered', async () => {
  await page.locator('summary', { hasText: 'Spalten' }).click();
  const offered = page.locator('details label');
  await expect(async () => (await offered.allInnerTexts()).map((one) => one.trim()).join(' '), 'VKE STA OR AKKU 1 AKKU 2 STW DB');
  await page.getByRole('checkbox', { name: 'STW' }).check();
  await expect(async () => (await columns()).join(' '), 'VKE STA AKKU 1 STW');
  await until(async () => /^[0-9A-F]{4}$/.test((await statusOf(page, line))[3]), 'the status word');
  await page.locator('summary', { hasText: 'Spalten' }).click();
});

test('a breakpoint stops the PLC before its line, which is marked', async () => {
  await toLine(page, line + 1);
  await page.keyboard.press('F9');
  await page.locator('[data-mode="HALT"]').waitFor();
  await page.getByText(`HALT in PB 1, Zeile ${line + 1}`).waitFor();
  await until(async () => /U +E 0\.1/.test(await haltLine()), 'the line');
  await expect(async () => (await statusOf(page, line)).slice(0, 2).join(' '), '1 1', 'status in HALT');
  await picture(page, 'sinumerik');
});

test('the stacks show where it stands, with the registers it has', async () => {
  await visit(page, server, 'diagnosis?page=stacks');
  const table = (name) => page.getByRole('table', { name });
  await table('B-Stack').getByText('OB 1').waitFor();
  await table('U-Stack').getByText(`main.s5:${line + 1}`).waitFor();
  const words = await table('U-Stack').innerText();
  assert.match(words, /AKKU1.*AKKU2/s);
  assert.doesNotMatch(words, /AR1|DI\b/);
  assert.equal(await table('L-Stack').count(), 0);
});

test('a step goes to the next statement, into a call, and out again', async () => {
  await visit(page, server, 'program?file=main.s5');
  await page.getByText(`HALT in PB 1, Zeile ${line + 1}`).waitFor();
  await page.getByRole('button', { name: /^Schritt/ }).click();
  await page.getByText(`HALT in PB 1, Zeile ${line + 2}`).waitFor();
  await page.getByRole('button', { name: /^Hinaus/ }).click();
  await page.getByText(/HALT in OB 1, Zeile/).waitFor();
  await until(async () => /SPA +PB 10/.test(await haltLine()), 'the next call of OB 1');
  await page.getByRole('button', { name: /^Hinein/ }).click();
  await page.getByText(/HALT in PB 10, Zeile/).waitFor();
});

test('go on: to the breakpoint in the next cycle; without it the PLC runs', async () => {
  await page.getByRole('button', { name: /^Fortsetzen/ }).click();
  await page.getByText(`HALT in PB 1, Zeile ${line + 1}`).waitFor();
  await page.locator('.code .cm-point-mark, .code .cm-halt-mark').first().waitFor();
  await toLine(page, line + 1);
  await page.keyboard.press('F9');
  await expect(() => page.locator('.code .cm-point-mark').count(), 0);
  await page.keyboard.press('F8');
  await page.locator('[data-mode="RUN"]').waitFor();
  await expect(() => page.locator('.code .cm-halt-line').count(), 0);
});

const block = (id) => page.getByRole('treeitem').filter({ has: page.locator('.id', { hasText: new RegExp(`^${id}$`) }) }).first();

test('the first statement of a block: it is being processed, though none of it has been', async () => {
  await block('PB 10').click();
  await page.locator('.work .head').getByText('PB 10', { exact: true }).waitFor();
  const first = (await text(page)).split('\n').findIndex((one) => /^PB 10\b/.test(one)) + 3;
  await toLine(page, first);
  await page.keyboard.press('F9');
  await page.getByText(`HALT in PB 10, Zeile ${first}`).waitFor();
  await expect(() => page.getByText('Der Baustein wird nicht bearbeitet').count(), 0);
  await page.keyboard.press('F9');
  await expect(() => page.locator('.code .cm-point-mark').count(), 0);
  await page.keyboard.press('F8');
  await page.locator('[data-mode="RUN"]').waitFor();
});

test('the tree has the blocks in their order and what they call; none can be loaded by itself', async () => {
  const ids = () => page.getByRole('treeitem').locator('.id').allInnerTexts();
  const kinds = [...new Set((await ids()).map((id) => id.split(' ')[0]))];
  assert.deepEqual(kinds, ['OB', 'PB', 'SB', 'FB', 'DB']);
  const count = (await ids()).length;
  await block('OB 1').locator('.twist').click();
  await until(async () => (await ids()).length > count, 'the calls of OB 1');
  assert.equal(await page.getByRole('button', { name: 'Baustein laden' }).count(), 0);
  assert.equal(await page.getByRole('button', { name: 'Neuer Baustein' }).count(), 1);
});

test('the cross reference leads to the line', async () => {
  await page.getByRole('tab', { name: 'Referenzdaten' }).click();
  await page.getByRole('searchbox', { name: 'Operand oder Symbol' }).fill('M 140.0');
  await page.locator('#program-panel button', { hasText: 'main.s5:' }).first().click();
  await page.locator('.work .head').getByText('PB 1', { exact: true }).waitFor();
});

test('online: the machine code of a block, to read', async () => {
  await page.getByRole('tab', { name: 'Online' }).click();
  await block('PB 1').click();
  await page.getByText('Nur lesen: aus der CPU').waitFor();
  await until(async () => /U +E 0\.0/.test(await content(page).innerText()), 'its statements');
  await page.getByRole('tab', { name: 'Offline' }).click();
});

test('the module information shows what the PLC has', async () => {
  await visit(page, server, 'diagnosis?page=information');
  await page.getByText('SINUMERIK 810').last().waitFor();
  await page.getByText('Merker (Byte)').waitFor();
  assert.equal(await page.getByText('Lokaldaten').count(), 0);
});

test('after a fault the stacks show the statement that caused it, with what the registers held', async () => {
  const workspace = scratch();
  const project = join(workspace, 'lamp.s5');
  writeFileSync(project, 'OB 1\n : SPA PB 5\n : BE\nPB 5\n : L KF +7\n : T DW 9\n : BE\n');
  const faulty = await open(await launch(project, workspace), 'diagnosis?page=stacks');
  const table = (name) => faulty.getByRole('table', { name });
  await table('U-Stack').getByText('lamp.s5:6').waitFor();
  assert.match(await table('U-Stack').innerText(), /AKKU1 00000007/);
  const calls = (await table('B-Stack').locator('tbody tr td:first-child').allInnerTexts()).join(' ');
  assert.equal(calls, 'PB 5 OB 1');
  await faulty.getByRole('tab', { name: 'Diagnosepuffer' }).click();
  const entry = faulty.getByRole('row').filter({ hasText: '6103 Transfer in fehlenden DB' });
  assert.match(await entry.innerText(), /0:00:0\d/, 'a PLC without a clock: the time since its start');
});
