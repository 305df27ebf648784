// The variable table: monitor, modify, force, files (S7-MGR-16).
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, message, open, serve, turn, until, visit, write } from './harness.mjs';

const server = await serve();
const page = await open(server, 'variables');
const row = (operand) => page.locator(`tr[data-operand='${operand}']`);
const status = (operand) => row(operand).locator('.value').innerText();
async function type(operand) {
  await page.locator('tbody tr').last().locator('input').first().fill(operand);
  await page.keyboard.press('Tab');
}

const asked = page.getByRole('dialog', { name: 'Änderungen speichern?' });
/** An empty table; what is not saved goes. */
async function fresh() {
  await page.getByRole('button', { name: 'Neu', exact: true }).click();
  await until(async () => (await asked.isVisible()) || (await page.locator('tbody tr').count()) === 1, 'the question or an empty table');
  if (await asked.isVisible()) await asked.getByRole('button', { name: 'Nicht speichern' }).click();
}

test('operands by address and by symbol show their status', async () => {
  await turn(page, 'RUN-P');
  await type('MW 20');
  await type('"Light barrier small"');
  await until(async () => (await status('MW 20')).includes('0'), 'a value');
  await until(async () => /^(0|1|TRUE|FALSE)$/i.test(await status('"Light barrier small"')), 'a bit');
});

test('modify writes all modify values at once', async () => {
  await row('MW 20').locator('.modify input').fill('W#16#1234');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

test('forcing shows a red F, the FRCE LED and the force list; releasing ends all three', async () => {
  await row('"Light barrier small"').locator('.modify input').fill('1');
  await row('"Light barrier small"').getByRole('button', { name: /forcen$/ }).click();
  await row('"Light barrier small"').locator('.mark b').waitFor();
  await expect(() => page.locator('[data-led="FRCE"]').getAttribute('data-state'), 'on');
  await page.getByRole('button', { name: 'Alle aufheben' }).click();
  await expect(() => page.locator('[data-led="FRCE"]').getAttribute('data-state'), 'off');
  await expect(() => row('"Light barrier small"').locator('.mark b').count(), 0);
});

test('monitored and modified at a trigger point (S7-MGR-16)', async () => {
  const dialog = page.getByRole('dialog');
  const trigger = async (what, point, once = false) => {
    await page.getByRole('button', { name: 'Trigger …' }).click();
    const part = dialog.getByRole('group', { name: what });
    await part.getByLabel('Triggerpunkt').selectOption(point);
    if (point !== 'now') await part.getByLabel('nur einmal').setChecked(once);
    await dialog.locator('footer').getByRole('button', { name: 'Schließen' }).click();
  };
  await trigger('Beobachten', 'stop');
  await trigger('Steuern', 'stop', true);
  await row('MW 20').locator('.modify input').fill('W#16#4711');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await page.locator('[data-modifying="stop"]').waitFor();
  assert.doesNotMatch(await status('MW 20'), /4711/);
  await turn(page, 'STOP');
  await expect(async () => (await status('MW 20')).includes('4711'), true);
  await expect(() => page.locator('[data-modifying]').count(), 0);
  await turn(page, 'RUN-P');
  await trigger('Beobachten', 'now');
  await trigger('Steuern', 'now');
  await row('MW 20').locator('.modify input').fill('W#16#1234');
  await page.getByRole('button', { name: 'Steuern', exact: true }).click();
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

const operands = (which = page) => which.locator('tbody tr[data-operand]').evaluateAll((rows) => rows.map((one) => one.dataset.operand));
const lists = async (...wanted) => {
  let seen;
  await until(async () => wanted.every((one) => seen?.includes(one)) || (seen = await operands(), false), () => `${wanted} in ${seen}`);
};

test('a range becomes a row for each of its operands', async () => {
  await type('MW 100..106');
  await lists('MW 100', 'MW 102', 'MW 104', 'MW 106');
  await type('A 1.6..2.1');
  await lists('A 1.6', 'A 1.7', 'A 2.0', 'A 2.1');
});

test('lines of a spreadsheet become rows, with format and modify value', async () => {
  const field = page.locator('tbody tr').last().locator('input').first();
  await field.focus();
  await field.evaluate((one) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', 'MW 200\tHEX\tW#16#12\nMD 204\nMB 210\tBIN');
    one.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  });
  await lists('MW 200', 'MD 204', 'MB 210');
  await expect(() => row('MW 200').locator('select').inputValue(), 'HEX');
  await expect(() => row('MW 200').locator('.modify input').inputValue(), 'W#16#12');
  await expect(() => row('MB 210').locator('select').inputValue(), 'BIN');
});

test('symbols are chosen from their list with the keyboard alone', async () => {
  await page.getByRole('button', { name: 'Aus den Symbolen …' }).press('Enter');
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('searchbox').fill('slider l');
  await dialog.getByLabel('Slider large').press('Space');
  await accessible(page, 'symbols to choose from');
  await dialog.getByRole('button', { name: '1 einfügen' }).press('Enter');
  await lists('"Slider large"');
  await expect(() => dialog.count(), 0);
});

test('a thousand rows are some rows of the page; the last one is reached', async () => {
  await type('M 100.0..200.7');
  await lists('M 100.0');
  await expect(async () => (await operands()).length < 120, true, 'few rows');
  await page.locator('main').evaluate((main) => {
    for (const one of [main, ...main.querySelectorAll('*')]) one.scrollTop = one.scrollHeight;
  });
  await lists('M 200.7');
  for (const [width, height] of [[768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    for (const one of [page.locator('thead th').nth(1), page.getByRole('button', { name: 'Steuern', exact: true })])
      await until(async () => (await one.boundingBox()).y > 0, 'heading and controls in sight');
  }
  assert.ok((await operands()).length < 120, `${(await operands()).length} rows`);
  await fresh();
  await expect(() => page.locator('tbody tr').count(), 1);
  await type('MW 20');
  await row('MW 20').locator('.modify input').fill('W#16#1234');
});

test('an operand that does not exist is told in its row, on a tablet as well', async () => {
  await type('E 0.0');
  await type('EW 99999');
  const problem = row('EW 99999').locator('.problem');
  await problem.waitFor();
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    // All columns are in sight; the row stays one line, and below the field that one is in all of the sentence can be read.
    const frame = page.locator('.table-frame');
    await until(() => frame.evaluate((one) => one.scrollWidth <= one.clientWidth), `all columns at ${width}`);
    await row('EW 99999').locator('.operand input').focus();
    await until(() => problem.evaluate((one) => one.scrollWidth <= one.clientWidth && one.textContent.length > 40), `all of it at ${width}`);
    assert.ok((await row('EW 99999').boundingBox()).height <= 26, `one line at ${width}`);
    await accessible(page, `problem at ${width}`);
  }
  await row('E 0.0').getByRole('button', { name: /löschen$/ }).click();
  await row('EW 99999').getByRole('button', { name: /löschen$/ }).click();
});

test('a table is saved as a file of the project and opened again', async () => {
  await page.getByRole('button', { name: 'Speichern unter …' }).click();
  await page.locator('#table-name').fill('belt');
  await page.keyboard.press('Enter');
  const table = join(server.project, 'belt.vat');
  await until(() => existsSync(table) && /^MW 20 ; AUTO ; W#16#1234$/m.test(readFileSync(table, 'utf-8')), table);
  await expect(() => page.locator('#variable-table').inputValue(), 'belt.vat');
  await fresh();
  await expect(() => page.locator('tbody tr').count(), 1);
  await page.locator('#variable-table').selectOption('belt.vat');
  await expect(async () => (await status('MW 20')).includes('1234'), true);
});

test('comment lines stay in the table; another one asks about what is not saved', async () => {
  const path = join(server.project, 'drives.vat');
  const text = '// operand ; format ; modify value\n// Drive 1: written by Anna\nMW 10 ; DEC ; 5\n\n// Drive 2\nMW 12 ; DEC\n';
  writeFileSync(path, text);
  const files = page.getByLabel('Tabelle', { exact: true });
  await until(() => files.locator('option').allInnerTexts().then((all) => all.includes('drives.vat')), 'the new file');
  await fresh();
  await files.selectOption('drives.vat');
  await row('// Drive 2').waitFor();
  await row('MW 10').locator('.modify input').fill('6');
  await files.selectOption('');
  await accessible(page, 'question');
  await asked.getByRole('button', { name: 'Abbrechen' }).click();
  assert.equal(await files.inputValue(), 'drives.vat');
  await page.getByRole('button', { name: 'Neu', exact: true }).click();
  await asked.getByRole('button', { name: 'Speichern', exact: true }).click();
  await expect(() => files.inputValue(), '');
  assert.equal(readFileSync(path, 'utf-8'), text.replace('; 5', '; 6'));
  await page.getByRole('button', { name: 'Neu', exact: true }).click();
  await expect(() => page.getByRole('dialog').count(), 0);
});

test('what somebody else has saved is not overwritten without a question', async () => {
  const path = join(server.project, 'drives.vat');
  const files = page.getByLabel('Tabelle', { exact: true });
  await files.selectOption('drives.vat');
  await row('MW 12').waitFor();
  writeFileSync(path, '// operand ; format ; modify value\nMW 12\nMW 500\n');
  await row('MW 500').waitFor();
  await row('MW 500').locator('.modify input').fill('6');
  writeFileSync(path, '// operand ; format ; modify value\nMW 12\nMW 502\n');
  await page.getByRole('button', { name: 'Speichern', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Tabelle überschreiben?' });
  await accessible(page, 'overwrite');
  assert.match(readFileSync(path, 'utf-8'), /MW 502/);
  await dialog.getByRole('button', { name: 'Abbrechen' }).click();
  await row('MW 500').waitFor();
  await page.getByRole('button', { name: 'Speichern', exact: true }).click();
  await dialog.getByRole('button', { name: 'Überschreiben' }).click();
  await until(() => /MW 500 ; AUTO ; 6/.test(readFileSync(path, 'utf-8')), () => readFileSync(path, 'utf-8'));
  await fresh();
});

test('an unnamed table is saved under a name, then the other one opens', async () => {
  await type('MW 30');
  await page.getByLabel('Tabelle', { exact: true }).selectOption('drives.vat');
  await asked.getByRole('button', { name: 'Speichern', exact: true }).click();
  await page.locator('#table-name').fill('mine');
  await page.keyboard.press('Enter');
  await row('MW 500').waitFor();
  assert.match(readFileSync(join(server.project, 'mine.vat'), 'utf-8'), /MW 30/);
  await fresh();
});

test('a value that cannot be read has its reason', async () => {
  await type('DB99.DBW 0');
  await row('DB99.DBW 0').getByText('DB 99 ist nicht geladen oder zu kurz.').waitFor();
});

const modifyValue = (operand) => row(operand).locator('.modify input');
const bars = () => page.locator('.message').allInnerTexts();

test('what cannot be modified is marked and named, the others are written', async () => {
  await fresh();
  for (const operand of ['A 124.3', 'MW 150', 'MW 152', 'MD 154']) await type(operand);
  await row('A 124.3').getByRole('button', { name: /forcen$/ }).click();
  await message(page, 'Zeile 1, A 124.3: Erst einen Steuerwert eintragen.');
  await modifyValue('A 124.3').fill('1');
  await row('A 124.3').getByRole('button', { name: /forcen$/ }).click();
  await row('A 124.3').locator('.mark b').waitFor();
  await expect(async () => (await bars()).length, 0, 'what was refused is done');

  await modifyValue('MW 150').fill('abc');
  await modifyValue('MW 152').fill('7');
  await row('MD 154').locator('select').selectOption('REAL');
  await modifyValue('MD 154').fill('2,5x');
  for (let time = 0; time < 2; time++) {
    await page.getByRole('button', { name: 'Steuern', exact: true }).click();
    await message(page, /Zeile 1, A 124.3: .*geforcet/);
    await message(page, /Zeile 2, MW 150: .*abc/);
    await message(page, /Zeile 4, MD 154: .*2,5x/);
    assert.equal((await bars()).length, 3);
    await expect(async () => (await status('MW 152')).includes('7'), true);
    await modifyValue('MW 152').fill('7');
  }
  const marked = () => page.locator('.modify input[aria-invalid=true]').evaluateAll((all) => all.map((one) => one.closest('tr').dataset.operand));
  assert.deepEqual(await marked(), ['A 124.3', 'MW 150', 'MD 154']);
  await accessible(page, 'refused modify values');
  await modifyValue('MW 150').fill('8');
  await expect(async () => (await marked()).join(), 'A 124.3,MD 154');
  await modifyValue('MW 150').press('Enter');
  await expect(async () => (await status('MW 150')).includes('8'), true);
  await page.getByRole('button', { name: 'Alle aufheben' }).click();
  await fresh();
});

test('a row that cannot be monitored leaves the others, and no value of another table', async () => {
  const files = page.getByLabel('Tabelle', { exact: true });
  const table = async (name, text, operand) => {
    writeFileSync(join(server.project, name), text);
    await until(() => files.locator('option').allInnerTexts().then((all) => all.includes(name)), name);
    await files.selectOption(name);
    await row(operand).waitFor();
  };
  await fresh();
  await write(page, { 'MW 180': 1111, 'MW 182': 2222, 'MW 186': 3333 });
  await table('good.vat', 'MW 180 ; DEC\nMW 182 ; DEC\n', 'MW 182');
  await expect(() => status('MW 182'), '2222');
  await table('bad.vat', 'MW 184 ; DEZ\nMW 186 ; DEC\n', 'MW 186');
  await expect(() => status('MW 186'), '3333');
  await row('MW 184').getByText('„DEZ“ ist kein Anzeigeformat').waitFor();
  assert.equal(await status('MW 184'), '?');
  await table('long.vat', `${'x'.repeat(401)}\nMW 180 ; DEC\n`, 'MW 180');
  await expect(() => status('MW 180'), '1111');
  await page.locator('tbody tr').first().getByText('400').waitFor();
  await files.selectOption('');
});

test('only what can be forced offers it; operands are not cut', async () => {
  const fresh = await open(server, 'variables');
  const line = (operand) => fresh.locator(`tr[data-operand='${operand}']`);
  for (const operand of ['E 0.0', 'MW 20', '"Light barrier small"', 'DB99.DBW 0']) {
    await fresh.locator('tbody tr').last().locator('input').first().fill(operand);
    await fresh.keyboard.press('Tab');
  }
  await line('E 0.0').getByRole('button', { name: /forcen$/ }).waitFor();
  await line('"Light barrier small"').getByRole('button', { name: /forcen$/ }).waitFor();
  for (const operand of ['MW 20', 'DB99.DBW 0']) {
    await line(operand).locator('.quiet').waitFor();
    assert.equal(await line(operand).getByRole('button', { name: /forcen$/ }).count(), 0, operand);
  }
  const field = line('"Light barrier small"').locator('.operand input');
  await until(() => field.evaluate((one) => one.scrollWidth <= one.clientWidth), 'the whole operand');
});

test('23 rows are in sight at 1280x800 as long as nothing is forced', async () => {
  const fresh = await open(server, 'variables');
  await fresh.locator('tbody tr').last().locator('input').first().fill('MW 10..100');
  await fresh.keyboard.press('Tab');
  await fresh.locator("tr[data-operand='MW 60']").waitFor();
  const inSight = () =>
    fresh.locator('.table-frame').evaluate((frame) => {
      const { bottom } = frame.getBoundingClientRect();
      const top = frame.querySelector('thead').getBoundingClientRect().bottom;
      const whole = (row) => row.getBoundingClientRect().top >= top - 1 && row.getBoundingClientRect().bottom <= bottom + 1;
      return [...frame.querySelectorAll('tr[data-operand]')].filter(whole).length;
    });
  await until(async () => (await inSight()) >= 23, '23 rows');
});

test('what the browser has stored may be anything', async () => {
  const fresh = await open(server, 'variables');
  for (const stored of ['null', '[]', '"x"', '1e308', JSON.stringify({ [server.project]: { path: 5 } })]) {
    await fresh.addInitScript((stored) => {
      for (const key of ['theme', 'language', 'variables', 'trends', 'tiles', 'pitch', 'comfortable', 'cpu.unfolded'])
        localStorage.setItem(`merker.${key}`, stored);
    }, stored);
    for (const view of ['variables', 'trends', 'io']) {
      await visit(fresh, server, view);
      await fresh.reload();
      await fresh.locator('[data-phase="open"]').waitFor();
      await fresh.locator('main section.view h1').waitFor({ state: 'attached' });
      assert.deepEqual(fresh.complaints, [], `${stored} in ${view}`);
    }
  }
});
