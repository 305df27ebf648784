// The six work steps of the course, chapter 4.1.6: what a student does from the project to the running program.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { problems, replaceAll, toLine } from './editor.mjs';
import { bit, expect, open, serve, turn, until, visit } from './harness.mjs';

const server = await serve('06-first-program');
const page = await open(server, 'projects');
const block = (id) => page.getByRole('treeitem').filter({ hasText: id });
/** Ctrl+S, and one file of the project has this text. */
async function save(source) {
  await page.keyboard.press('Control+s');
  const folder = join(server.workspace, 'merker', 'Manfred');
  const files = () => readdirSync(folder).filter((name) => name.endsWith('.awl'));
  await until(() => files().some((name) => readFileSync(join(folder, name), 'utf-8') === source), 'the saved file');
  await expect(() => page.getByText('nicht gespeichert').count(), 0);
}
async function newBlock(id, source) {
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  await page.getByLabel(/^Baustein, z/).fill(id);
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await page.locator('.work .head').filter({ hasText: id }).waitFor();
  await replaceAll(page, source);
  await expect(() => problems(page).count(), 0, 'problems');
  await save(source);
}

test('the six work steps of chapter 4.1.6, without a connected PLC (S7-SIM-01)', async (course) => {
  await course.test('1. define the project (S7-SIM-04)', async () => {
    await page.getByRole('button', { name: 'Neues Projekt …' }).click();
    await page.getByLabel('Projektname').fill('Manfred');
    await page.getByRole('button', { name: 'Anlegen' }).click();
    await block('OB 1').first().waitFor();
    // A new CPU is empty and in STOP, as that of a simulator: steps 5 and 6 are still to be done, and it says so.
    await page.locator('[data-mode="STOP"]').waitFor();
    await page.locator('[data-hint="empty"]').getByText('Programm laden').waitFor();
  });

  await course.test('2. define blocks and program them with the editor (S7-SIM-05)', async () => {
    await newBlock('FC 1', `FUNCTION FC 1 : VOID
TITLE = Motor with two push-buttons
VERSION : 0.1
BEGIN
NETWORK
TITLE = On, off, hold
      U(    ;
      O     E 0.0;
      O     A 1.0;
      )     ;
      UN    E 0.1;
      =     A 1.0;
END_FUNCTION
`);
    await block('FC 1').first().waitFor();
  });

  await course.test('3. OB 1 with the entry of the program (S7-SIM-06)', async () => {
    await block('OB 1').first().click();
    await page.locator('.work .head').filter({ hasText: 'OB 1' }).waitFor();
    const entry = `ORGANIZATION_BLOCK OB 1
TITLE = Entry of the program
VERSION : 0.1
BEGIN
NETWORK
TITLE = Motor
      CALL  FC 1;
END_ORGANIZATION_BLOCK
`;
    await replaceAll(page, entry);
    await expect(() => problems(page).count(), 0, 'problems');
    await save(entry);
  });

  await course.test('4. start and configure the simulator (S7-SIM-07, S7-SIM-03)', async () => {
    await turn(page, 'STOP');
    await page.locator('[data-led="STOP"][data-state="on"]').waitFor();
    await visit(page, server, 'io');
    for (const operand of ['EB 0', 'AB 1']) {
      await page.locator('#tile-operand').fill(operand);
      await page.locator('#tile-operand').press('Enter');
    }
    await page.locator('button[data-operand="E 0.0"]').first().waitFor();
    await page.locator('button[data-operand="A 1.0"]').first().waitFor();
  });

  await course.test('5. transfer the blocks to the target system (S7-SIM-08)', async () => {
    await visit(page, server, 'projects');
    await page.getByRole('button', { name: 'In die CPU laden' }).click();
    await page.getByText('Projekt und CPU sind gleich.').waitFor();
    await page.locator('[data-hint="empty"]').waitFor({ state: 'detached' });
  });

  await course.test('6. CPU to RUN: its LED is on, the cycle counter increases, the program works (S7-SIM-09, -10)', async () => {
    await turn(page, 'RUN');
    await expect(() => page.locator('[data-led="RUN"]').getAttribute('data-state'), 'on');
    const cycles = async () => Number(await page.locator('[data-value="cycles"]').innerText());
    const before = await cycles();
    await until(async () => (await cycles()) > before, 'more cycles');

    await visit(page, server, 'io');
    const press = (operand) => page.locator(`button[data-operand="${operand}"]`).first().click();
    await expect(() => bit(page, 'A 1.0'), '0');
    await press('E 0.0');
    await expect(() => bit(page, 'E 0.0'), '1');
    await expect(() => bit(page, 'A 1.0'), '1', 'motor on');
    await press('E 0.0');
    await expect(() => bit(page, 'E 0.0'), '0');
    await expect(() => bit(page, 'A 1.0'), '1', 'the motor holds itself');
    await press('E 0.1');
    await expect(() => bit(page, 'A 1.0'), '0', 'motor off');
  });

  await course.test('and its status shows what flows (S7-EDIT-21)', async () => {
    await visit(page, server, 'program?block=FC 1');
    await toLine(page, 7);
    await page.getByRole('switch', { name: 'Status' }).click();
    await page.locator('.code .cm-status-row .cm-status-vke').filter({ hasText: /^[01]$/ }).first().waitFor();
  });
});
