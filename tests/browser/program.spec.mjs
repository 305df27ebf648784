// The program view: blocks, editor, problems while typing, declarations, load, compare (S7-EDIT, S7-MGR-08..10, -15).
import assert from 'node:assert/strict';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { content, problems, replaceAll, text, toLine } from './editor.mjs';
import { expect, message, open, picture, quiet, serve, turn, until, visit } from './harness.mjs';

const server = await serve('sorting-plant');
const file = join(server.project, 'sorting.awl');
const page = await open(server, 'program?file=sorting.awl');
const block = (id) => page.locator('[role=treeitem][aria-level="1"]').filter({ has: page.locator('.id', { hasText: new RegExp(`^${id}$`) }) }).first();
const button = (name) => page.getByRole('button', { name, exact: true });
const saved = () => readFileSync(file, 'utf-8');
const says = (words) => message(page, words);
const has = (locator, words) => until(async () => words.test(await locator.innerText()), words);

test('the tree holds all blocks with what they call (S7-MGR-08)', async () => {
  await block('OB 1').waitFor();
  await block('OB 1').focus();
  const before = await page.getByRole('treeitem').count();
  await page.keyboard.press('ArrowRight');
  await until(async () => (await page.getByRole('treeitem').count()) > before, 'the calls of OB 1');
  await has(block('FB 2'), /Slider/);
  await until(async () => /\d+ B/.test(await block('FB 2').getAttribute('title')), 'its size');
});

test('a block opens where it begins (S7-MGR-10)', async () => {
  await block('FB 2').click();
  await until(async () => (await page.locator('.work .head').innerText()).includes('"Slider"'), 'the block of the line');
  await expect(() => text(page), saved());
});

test('the declaration table shows address, declaration, name, type, initial value, comment (S7-EDIT-01, -02)', async () => {
  await block('FB 1').click();
  await page.locator('.work .head button').click();
  const row = page.locator('.frame tr').filter({ has: page.getByLabel('Name Filter', { exact: true }) });
  await expect(() => row.locator('td').nth(0).innerText(), '2.0');
  await expect(() => row.locator('td').nth(1).innerText(), 'in');
  await expect(() => page.getByLabel('Typ Filter', { exact: true }).inputValue(), 'S5TIME');
  await expect(() => page.getByLabel('Anfangswert Filter', { exact: true }).inputValue(), 'S5T#50MS');
});

test('a block that this CPU cannot have is refused in the dialog, and no file is written', async () => {
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  for (const [name, others] of [['FC 99999', 'FC 0 … 127'], ['DB 0', 'DB 1 … 127'], ['OB 2', 'OB 1, 10,'], ['XY 1', 'UDT']]) {
    await page.getByLabel(/^Baustein, z/).fill(name);
    await page.getByRole('button', { name: 'Anlegen' }).click();
    await page.getByRole('alert').getByText(others).waitFor();
  }
  await page.keyboard.press('Escape');
  for (const file of ['fc99999.awl', 'db0.awl', 'ob2.awl']) assert.ok(!existsSync(join(server.project, file)), file);
});

const create = async (name, more) => {
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  await page.getByLabel(/^Baustein, z/).fill(name);
  await more?.();
  await page.getByRole('button', { name: 'Anlegen' }).click();
};
const dispose = async (path) => {
  await expect(() => page.locator('.bar .path').innerText(), path);
  await page.getByRole('button', { name: 'Datei löschen' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Datei löschen' }).click();
  await until(() => !existsSync(join(server.project, path)), `${path} gone`);
};

test('the new block is the one selected in the tree; a data type and a table of variables begin as one', async () => {
  await create('FC 77');
  await page.locator('[role="treeitem"][aria-selected="true"]').filter({ hasText: 'FC 77' }).waitFor();
  assert.equal(await page.locator('[role="treeitem"][aria-selected="true"]').count(), 1);
  await dispose('fc77.awl');
  await create('udt 7');
  await until(async () => (await text(page)).startsWith('TYPE UDT 7\nSTRUCT'), 'the data type');
  await expect(() => problems(page).count(), 0, 'problems');
  await create('DB 77', async () => {
    await page.getByLabel('Art des Datenbausteins').selectOption('DB vom Typ');
    await expect(() => page.getByLabel('Datentyp').inputValue(), 'UDT 7');
  });
  await until(async () => (await text(page)).startsWith('DATA_BLOCK DB 77 UDT 7\n'), 'a data block of the type');
  await expect(() => problems(page).count(), 0, 'problems');
  await dispose('db77.awl');
  await page.locator('.files').getByText('udt7.awl').click();
  await dispose('udt7.awl');
  await create('OB 35');
  await until(async () => /^ORGANIZATION_BLOCK OB 35\n[^]*OB35_EXC_FREQ : INT ;\n  OB35_DATE_TIME : DATE_AND_TIME ;/.test(await text(page)), 'its start information');
  await expect(() => problems(page).count(), 0, 'problems');
  await dispose('ob35.awl');
  await create('VAT 1');
  await page.locator('#variable-table').waitFor();
  await expect(() => page.locator('#variable-table').inputValue(), 'vat1.vat');
  rmSync(join(server.project, 'vat1.vat'));
  await visit(page, server, 'program');
  await block('OB 1').first().waitFor();
});

test('the definition of the project is neither renamed nor deleted here', async () => {
  await page.locator('.files').getByText('merker.toml').click();
  await expect(() => page.locator('.bar .path').innerText(), 'merker.toml');
  assert.equal(await page.getByRole('button', { name: 'Datei löschen' }).count(), 0);
  assert.equal(await page.getByRole('button', { name: 'Datei umbenennen' }).count(), 0);
});

test('the dialog for a new block forgets the name that was not taken', async () => {
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  await page.getByLabel(/^Baustein, z/).fill('DB 2');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  await expect(() => page.getByLabel(/^Baustein, z/).inputValue(), '');
  await page.keyboard.press('Escape');
});

test('the program alone is without the drawer, which comes back with the rest', async () => {
  const drawer = page.locator('#program-panel');
  await drawer.waitFor();
  await content(page).focus();
  await page.keyboard.press('Alt+F10');
  await expect(() => drawer.isVisible(), false);
  await page.getByRole('tab', { name: /^Fehler/ }).click();
  await drawer.waitFor();
  await page.keyboard.press('Alt+F10');
  await page.locator('header').first().waitFor();
  await drawer.waitFor();
  await page.keyboard.press('Alt+F10');
  await expect(() => drawer.isVisible(), false);
  await page.keyboard.press('Alt+F10');
  await drawer.waitFor();
});

test('a new data block is shared, an instance or of a type (S7-MGR-12)', async () => {
  await page.getByRole('button', { name: 'Neuer Baustein' }).click();
  await page.getByLabel(/^Baustein, z/).fill('DB 99');
  const kind = page.getByLabel('Art des Datenbausteins');
  await expect(() => kind.inputValue(), 'shared');
  await kind.selectOption('DB vom Typ');
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await page.getByRole('alert').getByText('noch keinen UDT').waitFor();
  await kind.selectOption('Instanz-DB');
  await accessible(page, 'a new data block');
  await page.getByLabel('Funktionsbaustein').selectOption({ label: 'SFB 4 TON' });
  await page.getByLabel('Funktionsbaustein').selectOption('FB 1');
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await until(async () => (await text(page)).startsWith('DATA_BLOCK DB 99 FB 1\n'), 'the instance');
  await expect(() => problems(page).count(), 0, 'problems');
  await dispose('db99.awl');
});

test('networks are shown with their titles and gone to (S7-EDIT-05)', async () => {
  await block('FB 1').click();
  const networks = page.getByLabel('Netzwerke', { exact: true });
  await until(async () => /Netzwerk 1: \S/.test(await networks.locator('option').nth(1).innerText()), 'a title');
});

test('a wrong line is marked while it is being typed, with code, sentence and hint (S7-EDIT-06)', async () => {
  await toLine(page, 47);
  await page.keyboard.insertText('      U     E 0.8;\n');
  await has(problems(page).first(), /P\d{4}.*0\.8|bit/i);
  await has(problems(page).first(), /sorting\.awl:47/);
  await page.locator('.code .cm-lintRange-error').first().waitFor();
  await picture(page, 'program-problem');
  await page.keyboard.press('Control+z');
  await expect(() => problems(page).count(), 0);
});

test('symbols are completed, in quotation marks (S7-EDIT-17)', async () => {
  await toLine(page, 47);
  await page.keyboard.type('      U "light barrier m');
  await page.locator('.code .cm-tooltip-autocomplete li').filter({ hasText: '"Light barrier middle"' }).click();
  await until(async () => (await text(page)).includes('U "Light barrier middle"'), 'the symbol');
  await button('Speichern').waitFor();
  await until(async () => {
    await page.keyboard.press('Control+z');
    return (await text(page)) === saved();
  }, 'the old text');
});

test('the right-click menu lists all symbols and inserts one (S7-EDIT-17)', async () => {
  await toLine(page, 47);
  await page.keyboard.press('Control+j');
  await page.getByRole('menuitem', { name: 'Symbol einfügen' }).click();
  const symbols = readFileSync(join(server.project, 'sorting.sym'), 'utf-8').match(/^"/gm).length;
  await expect(() => page.getByRole('listbox').getByRole('option').count(), symbols);
  await page.getByRole('searchbox', { name: 'Filter' }).fill('slider small');
  await page.getByRole('listbox').getByRole('option', { name: /^Slider small/ }).click();
  const times = (source) => source.split('"Slider small"').length;
  await until(async () => times(await text(page)) === times(saved()) + 1, 'the symbol');
  await content(page).focus();
  await page.keyboard.press('Control+z');
  await until(async () => (await text(page)) === saved(), 'the old text');
});

test('symbolic and absolute display change what is shown, not what is written (S7-EDIT-18)', async () => {
  await block('OB 1').click();
  await page.getByRole('combobox', { name: 'Anzeige', exact: true }).selectOption('absolute');
  await page.locator('.code .cm-shown-operand').filter({ hasText: /^[EA] \d\.\d$/ }).first().waitFor();
  await expect(() => text(page), saved());
  await page.getByRole('combobox', { name: 'Anzeige', exact: true }).selectOption('written');
  await expect(() => page.locator('.code .cm-shown-operand').count(), 0);
});

test('the mnemonics are switched as one step that can be undone (S7-EDIT-24)', async () => {
  await page.getByLabel('Mnemonik').selectOption('international');
  await until(async () => /^\s+AN\s+#BeamSmall;/m.test(await text(page)), 'international mnemonics');
  await expect(() => problems(page).count(), 0);
  await content(page).focus();
  await page.keyboard.press('Control+z');
  await until(async () => (await text(page)) === saved(), 'the old text');
});

test('in RUN loading is refused with the words of the CPU, in RUN-P it is done (S7-SIM-11, S7-EDIT-07)', async () => {
  await turn(page, 'RUN');
  await toLine(page, 1);
  await page.keyboard.insertText('// changed\n');
  await page.keyboard.press('Control+s');
  await until(() => saved().startsWith('// changed\n'), 'the saved file');
  await page.getByText('≠ CPU').waitFor();
  await quiet(page);
  await button('Laden').click();
  await says(/RUN/);
  await quiet(page);
  await turn(page, 'RUN-P');
  await button('Laden').click();
  await says('Programm geladen.');
  await expect(() => page.getByText('≠ CPU').count(), 0);
  await quiet(page);
});

test('save and load pressed at once save once, and nobody else is suspected', async () => {
  const source = saved().replace('SA    #FilterTime', 'SS    #FilterTime');
  await replaceAll(page, source);
  await page.keyboard.press('Control+s');
  await page.keyboard.press('Control+l');
  await expect(saved, source);
  await says(/geladen/);
  assert.equal(await page.getByText('anderswo').count(), 0);
  await replaceAll(page, source.replace('SS    #FilterTime', 'SA    #FilterTime'));
  await page.keyboard.press('Control+s');
  await expect(saved, source.replace('SS    #FilterTime', 'SA    #FilterTime'));
});

test('compare shows what differs between project and CPU, side by side (S7-MGR-15)', async () => {
  await replaceAll(page, saved().replace('      SA    #FilterTime', '      NOP   0;\n      NOP   0;\n      SE    #FilterTime'));
  await page.keyboard.press('Control+s');
  await until(async () => (await block('FB 1').innerText()).includes('≠'), 'the mark of a difference');
  await block('FB 1').click();
  await page.getByRole('toolbar', { name: 'FB 1' }).getByRole('button', { name: 'Vergleich' }).click();
  await page.locator('#program-panel .cm-changedLine').first().waitFor();
  // Sources: what is inserted makes no difference of what follows.
  await expect(() => page.locator('#program-panel [role=status]').innerText(), 'Unterschied 1 von 1');
  const shown = () => page.locator('#program-panel .texts').evaluate((one) => one.shadowRoot.textContent);
  await until(async () => /#FilterTime/.test(await shown()), 'the source');
  await picture(page, 'program-compare');
});

test('the comparison follows the block that is chosen, and what the CPU gets', async () => {
  const heads = () => page.locator('#program-panel .heads').innerText();
  const differences = () => page.locator('#program-panel [role=status]').innerText();
  await block('FB 2').click();
  await until(async () => /Projekt: FB 2\s+CPU: FB 2/.test(await heads()), heads);
  await expect(differences, '0 Unterschiede');
  // By keys, and by the cursor in the text as well.
  await block('FB 1').focus();
  await page.keyboard.press('Enter');
  await until(async () => /Projekt: FB 1\s/.test(await heads()), heads);
  await expect(differences, 'Unterschied 1 von 1');
  await toLine(page, saved().split('\n').findIndex((line) => line.startsWith('FUNCTION_BLOCK "Slider"')) + 2);
  await until(async () => /Projekt: FB 2\s/.test(await heads()), heads);
  // Nobody looks while the drawer is folded; who asks opens it.
  await button('Meldungen und Ergebnisse').click();
  await block('FB 1').click();
  await page.getByRole('toolbar', { name: 'FB 1' }).getByRole('button', { name: 'Vergleich' }).click();
  await expect(() => page.locator('#program-panel').isVisible(), true, 'the drawer');
  await until(async () => /Projekt: FB 1\s/.test(await heads()), heads);
});

test('one block is loaded alone (S7-EDIT-07)', async () => {
  await page.getByRole('button', { name: 'Baustein laden' }).click();
  await says('Programm geladen.');
  await until(async () => (await block('FB 1').innerText()).includes('='), 'the same again');
  await expect(() => page.locator('#program-panel [role=status]').innerText(), '0 Unterschiede', 'the comparison as well');
  await quiet(page);
});

test('where an operand is used (S7-EDIT-22)', async () => {
  await page.getByRole('tab', { name: 'Referenzdaten' }).click();
  await page.getByLabel('Operand oder Symbol').fill('A 1.0');
  const rows = page.locator('#program-panel tbody tr');
  await until(async () => /A 1\.0/.test((await rows.first().innerText().catch(() => '')) ?? ''), 'a row');
  const place = rows.first().getByRole('button');
  const line = (await place.innerText()).split(':')[1];
  await place.click();
  await expect(() => page.locator('.code .cm-lineNumbers .cm-activeLineGutter').innerText(), line);
});

test('online: the blocks of the CPU, their text, upload and delete (S7-MGR-15)', async () => {
  await page.getByRole('tab', { name: 'Online' }).click();
  await block('FC 1').click();
  await page.getByText('Nur lesen: aus der CPU').waitFor();
  await until(async () => /^\s*(\d+:)?.*\bBE\b/m.test(await text(page)), 'the listing');
  await button('Laden in PG').click();
  await says(/Aus der CPU geholt: .*FC\s?1/i);
  await quiet(page);
  await turn(page, 'STOP');
  await button('In der CPU löschen').click();
  await page.getByRole('dialog').getByRole('button', { name: 'In der CPU löschen' }).click();
  await expect(() => block('FC 1').count(), 0);
});

test('a copy of a block of the CPU is to read, says that it is no part of the program, and can be deleted', async () => {
  assert.ok(existsSync(join(server.project, 'online/FC1.awl')));
  await page.getByRole('tab', { name: 'Offline' }).click();
  await page.getByRole('button', { name: 'online/FC1.awl' }).click();
  await page.getByRole('note').filter({ hasText: 'Kopie aus der CPU' }).waitFor();
  const before = await text(page);
  await content(page).focus();
  await page.keyboard.type('// lost');
  assert.equal(await text(page), before);
  assert.equal(await button('Laden').count(), 0);
  await accessible(page, 'a copy');
  await dispose('online/FC1.awl');
});
