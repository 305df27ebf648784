// A STEP 5 project of a SINUMERIK 810: every view says what there is of it, and nothing breaks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { content, problems, replaceAll, text } from './editor.mjs';
import { expect, open, serve, turn, until, visit } from './harness.mjs';

const server = await serve('step5/tool-changer');
const page = await open(server, 'projects');
const views = ['projects', 'hardware', 'symbols', 'program', 'io', 'variables', 'process', 'trends', 'diagnosis', 'nc'];

test('the tree is that of a SINUMERIK', async () => {
  const tree = page.locator('.root');
  await tree.getByText('SINUMERIK 810').waitFor();
  assert.ok(!(await tree.innerText()).includes('MPI'));
  await tree.getByText('S5-Programm').waitFor();
});

for (const view of views) {
  test(`${view} opens without a complaint`, async () => {
    await visit(page, server, view);
    await page.locator('main h1').first().waitFor();
    await accessible(page, view);
    assert.equal(await page.locator('.message.problem').count(), 0);
  });
}

test('a changed listing is loaded: the PLC begins again with it', async () => {
  await visit(page, server, 'program?file=main.s5');
  await until(async () => (await content(page).innerText()).includes('OB 1'), 'the listing');
  const before = await text(page);
  await replaceAll(page, before.replace(/OB 1\b/, 'OB 99'));
  await until(async () => (await problems(page).count()) > 0, 'a problem');
  await page.getByRole('button', { name: 'Laden', exact: true }).click();
  await expect(() => page.getByRole('tab', { name: /^Fehler/ }).getAttribute('aria-selected'), 'true');
  await replaceAll(page, before);
  await expect(() => problems(page).count(), 0);
  await page.getByRole('button', { name: 'Laden', exact: true }).click();
  await page.locator('.message.done').first().waitFor();
  await page.locator('[data-mode="RUN"]').waitFor();
});

const block = (id) => page.getByRole('treeitem').filter({ hasText: new RegExp(`${id}\\b`) }).first();

test('a new block, and what differs between project and PLC: in the tree and source beside source', async () => {
  await visit(page, server, 'program');
  await until(async () => (await block('PB 1').innerText()).includes('='), 'nothing differs');
  for (const id of ['PB 7', 'FB 99', 'DB 99']) {
    await page.getByRole('button', { name: 'Neuer Baustein' }).click();
    await page.getByLabel('Baustein, z. B. PB 1').fill(id);
    await page.getByRole('dialog').getByRole('button', { name: 'Anlegen' }).click();
    await until(async () => (await block(id).innerText()).includes('◐'), `${id} only in the project`);
  }
  await expect(() => problems(page).count(), 0);
  await visit(page, server, 'program?file=main.s5');
  await until(async () => (await content(page).innerText()).includes('OB 1'), 'the listing');
  const before = await text(page);
  await replaceAll(page, before.replace(' : U    E 1.0\n', ' : U    E 1.0\n : NOP 0\n'));
  await page.keyboard.press('Control+s');
  await until(async () => (await block('PB 1').innerText()).includes('≠'), 'the mark of a difference');
  await block('PB 1').click();
  await page.getByRole('toolbar', { name: 'PB 1' }).getByRole('button', { name: 'Vergleich' }).click();
  const status = () => page.locator('.comparison [role=status]').innerText();
  const shown = () => page.locator('.comparison .texts').evaluate((one) => one.shadowRoot.textContent);
  await expect(status, 'Unterschied 1 von 1');
  assert.match(await shown(), /NETZWERK 2 {2}a rising edge/);
  await visit(page, server, 'compare?block=PB 1');
  await page.getByRole('switch', { name: 'Maschinencode' }).waitFor();
  await expect(status, 'Unterschied 1 von 1');
  assert.match(await shown(), /NETZWERK 2 {2}a rising edge/);
  await visit(page, server, 'program');
  await page.getByRole('button', { name: 'Laden', exact: true }).click();
  await until(async () => (await block('PB 7').innerText()).includes('='), 'all loaded');
});

test('the listing is there to read', async () => {
  await visit(page, server, 'program');
  await page.locator('.files .path', { hasText: '.s5' }).first().click();
  await until(async () => (await content(page).innerText()).length > 100, 'a listing');
});

test('a data block begins with the values of the listing; only what differs is coloured', async () => {
  await visit(page, server, 'program');
  await page.getByRole('treeitem', { name: /^DB 10\b/ }).click();
  await page.getByRole('button', { name: 'Datensicht' }).press('Enter');
  const row = page.locator("tr[data-path='DW 0']");
  await expect(() => row.locator('.initial').innerText(), '1');
  await expect(() => row.locator('.actual').innerText(), '1');
  assert.equal(await row.locator('.changed').count(), 0);
  await page.locator("tr[data-path='DW 1']").getByRole('textbox').fill('5');
  await page.keyboard.press('Enter');
  await page.locator("tr[data-path='DW 1'] .changed", { hasText: '5' }).waitFor();
  await page.getByRole('button', { name: 'Datensicht' }).press('Enter');
});

test('the program structure has the function blocks of the basic program', async () => {
  for (const name of ['Referenzdaten', 'Programmstruktur']) await page.getByRole('tab', { name }).click();
  const structure = page.getByRole('table', { name: 'Programmstruktur' });
  await until(async () => /PB 30\b[^]*FB 61\b[^]*der CPU/.test(await structure.innerText()), 'FB 61 below PB 30');
});

test('the PLC runs, stops, and its variables are seen', async () => {
  await visit(page, server, 'io');
  await page.locator('#tile-operand').fill('MB 20');
  await page.locator('#tile-operand').press('Enter');
  await page.locator('button[data-operand="M 20.0"]').first().waitFor();
  await turn(page, 'STOP');
  await turn(page, 'RUN');
  const cycles = async () => Number(await page.locator('[data-value="cycles"]').innerText());
  const before = await cycles();
  await until(async () => (await cycles()) > before, 'more cycles');
});
