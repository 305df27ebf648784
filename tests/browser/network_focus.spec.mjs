// Where the keyboard is in KOP and FUP: a block opened from the list, headings, edits that are on their way.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { text } from './editor.mjs';
import { expect, message, open, quiet } from './harness.mjs';
import { holder, networksOf, OF, project } from './networks.mjs';

const plc = await project('314C-2 PtP', 'main.awl', OF(['U E 0.0;', '= A 1.0;']));
const page = await open(plc, 'program?file=main.awl', { height: 720 });
const { network, press, field, elements, statements, inside, operand, drawn } = networksOf(page);
const { hold, release } = holder(page);

test('a block opened from the list has the keyboard', async () => {
  await drawn('kop', `${OF(['U E 0.0;', '= A 1.0;'])}FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      U     E 2.0;\n      =     A 2.0;\nEND_FUNCTION\nFUNCTION FC 2 : VOID\nBEGIN\nEND_FUNCTION\n`);
  await press('Control+s');
  const block = page.locator('[role=treeitem]').filter({ hasText: 'FC 1' }).first();
  await block.focus();
  await press('Enter');
  await expect(elements, 'Schließerkontakt E 2.0 | Spule =, A 2.0');
  await inside();
  await press('F2');
  await operand('E 2.1');
  await expect(async () => (await statements()).includes('U E 2.1;'), true);
  // One without a network as well: there the first one is made.
  const empty = page.locator('[role=treeitem]').filter({ hasText: 'FC 2' }).first();
  await empty.focus();
  await press('Enter');
  await inside();
  await press('Control+r');
  await expect(() => page.locator('[data-network]').count(), 1);
  await inside();
  await page.locator('[role=treeitem]').filter({ hasText: 'OB 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 0.0 | Spule =, A 1.0');
  await inside();
});

test('keys pressed in the list save, and change nothing else', async () => {
  await page.evaluate(() => (window.same = true));
  const list = page.getByRole('tree');
  await page.locator('[aria-label="Schließerkontakt E 0.0"]').click();
  await press('F2');
  await operand('E 0.7');
  // The edit may still be on its way to the drawing: the keyboard stays where it goes now.
  await list.getByRole('treeitem').first().focus();
  await expect(async () => (await statements()).includes('U E 0.7;'), true);
  const changed = await text(page);
  for (const key of ['F2', 'F3', 'F7', 'Delete']) {
    await list.getByRole('treeitem').first().focus();
    await press(key);
    assert.equal(await text(page), changed, key);
    assert.ok(await list.evaluate((tree) => tree.contains(document.activeElement)), key);
  }
  await quiet(page);
  await press('Control+s');
  await message(page, 'main.awl gespeichert');
  await press('Control+r');
  await inside();
  await press('F2');
  await field().waitFor();
  await press('Control+r');
  await inside();
  await page.getByRole('button', { name: 'Titel und Kommentar von Netzwerk 1' }).click();
  await press('Control+r');
  await inside();
  await page.getByRole('searchbox', { name: 'Element suchen' }).focus();
  await press('Control+r');
  await inside();
  assert.ok(await page.evaluate(() => window.same), 'the page was loaded anew');
});

test('who stands at the heading of a network is in it', async () => {
  await drawn('kop', OF(['U E 0.0;', '= A 1.0;'], 'NETWORK\n      U     E 0.1;\n      =     A 1.1;\nNETWORK\n      U     E 0.2;\n      =     A 1.2;\n'));
  await network(1).locator('[data-node]').first().click();
  await network(2).locator('[data-head]').focus();
  await press('F2');
  await operand('E 0.7');
  await expect(async () => (await statements()).includes('U E 0.7; U E 0.1; = A 1.1;'), true);
  await network(3).locator('[data-head]').focus();
  await press('Control+Delete');
  await expect(() => page.locator('[data-network]').count(), 2);
  await expect(async () => (await statements()).includes('E 0.2'), false);
  // Undone, there is a network to go on with.
  await press('Control+z');
  await expect(() => page.locator('[data-network]').count(), 3);
  await press('Home', 'F2');
  await operand('E 0.6');
  await expect(async () => (await statements()).includes('E 0.6'), true);
});

test('a block that was never open has the keyboard in its first network', async () => {
  await drawn('kop', `${OF(['U E 0.0;', '= A 1.0;'])}FUNCTION FC 1 : VOID\nVAR_TEMP\n  x : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n      U     E 2.0;\n      =     A 2.0;\nEND_FUNCTION\n`);
  await press('Control+s');
  await page.getByRole('treeitem', { name: 'FC 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 2.0 | Spule =, A 2.0');
  await inside();
  await press('F2');
  await operand('E 2.1');
  await expect(async () => (await statements()).includes('U E 2.1; U E 2.0;'), true);
  // Other mnemonics, the same block.
  await page.getByRole('combobox', { name: 'Mnemonik' }).selectOption('international');
  await expect(elements, 'Schließerkontakt I 2.1 | Schließerkontakt I 2.0 | Spule =, Q 2.0');
  await page.getByRole('combobox', { name: 'Mnemonik' }).selectOption('german');
  await expect(elements, 'Schließerkontakt E 2.1 | Schließerkontakt E 2.0 | Spule =, A 2.0');
});

test('a block is found in a text that was not saved', async () => {
  const fc = (n) => `FUNCTION FC ${n} : VOID\nBEGIN\nNETWORK\n      U     E ${n}.0;\n      =     A ${n}.0;\nEND_FUNCTION\n`;
  await drawn('kop', `${OF(['U E 0.0;', '= A 1.0;'])}${[1, 2, 3].map(fc).join('')}`);
  await press('Control+s');
  await message(page, 'main.awl gespeichert');
  await page.getByRole('treeitem', { name: 'FC 3' }).first().waitFor();
  for (let i = 0; i < 6; ++i) {
    await press('Control+r');
    await expect(() => page.locator('[data-network]').count(), 2 + i);
    await inside();
  }
  for (const n of [2, 3, 1]) {
    await page.getByRole('treeitem', { name: `FC ${n}` }).first().click();
    await expect(elements, `Schließerkontakt E ${n}.0 | Spule =, A ${n}.0`);
  }
});

test('undo that leads to another block marks it in the list', async () => {
  await drawn('kop', `${OF(['U E 0.0;', '= A 1.0;'])}FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      U     E 2.0;\n      =     A 2.0;\nEND_FUNCTION\n`);
  await press('Control+s');
  await page.getByRole('treeitem', { name: 'OB 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 0.0 | Spule =, A 1.0');
  await inside();
  await press('Home', 'F2');
  await operand('E 0.7');
  await expect(async () => (await statements()).includes('U E 0.7;'), true);
  await page.getByRole('treeitem', { name: 'FC 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 2.0 | Spule =, A 2.0');
  await press('Control+z');
  await expect(async () => (await elements()).startsWith('Schließerkontakt E 0.0'), true);
  await expect(() => page.locator('[role=treeitem][aria-selected=true]').innerText().then((text) => text.slice(0, 4)), 'OB 1');
});

test('a block opened while an edit is on its way stays open', async () => {
  await drawn('kop', `${OF(['U E 0.0;', '= A 1.0;'])}FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n      U     E 2.0;\n      =     A 2.0;\nEND_FUNCTION\n`);
  await press('Control+s');
  await page.getByRole('treeitem', { name: 'OB 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 0.0 | Spule =, A 1.0');
  await inside();
  await hold();
  await press('Home', 'F3');
  await page.getByRole('treeitem', { name: 'FC 1' }).first().click();
  await expect(elements, 'Schließerkontakt E 2.0 | Spule =, A 2.0');
  await release();
  await expect(async () => (await statements()).includes('UN ??.?;'), true);
  await expect(elements, 'Schließerkontakt E 2.0 | Spule =, A 2.0');
  await inside();
});
