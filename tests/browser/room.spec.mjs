// How much of the program is in sight, and that nothing pushes its text: edges, folding parts, the program alone.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { toLine } from './editor.mjs';
import { expect, launch, leave, open, quiet, serve, turn, until, visit, write } from './harness.mjs';
import { crowding } from './layout.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'program?file=sorting.awl');
const edge = (name) => page.getByRole('separator', { name });
const button = (name) => page.getByRole('button', { name, exact: true });
/** Lines of the text that can be read from top to bottom. */
const numbers = (look = page) => look.locator('.code .cm-scroller').evaluate((scroller) => {
  const head = scroller.parentElement.querySelector('.cm-panels-top, .cm-status-head')?.getBoundingClientRect().bottom ?? 0;
  const { top, bottom } = scroller.getBoundingClientRect();
  return [...scroller.querySelectorAll('.cm-lineNumbers .cm-gutterElement')].flatMap((one) => {
    const line = one.getBoundingClientRect();
    return line.height > 0 && line.top >= Math.max(top, head) - 1 && line.bottom <= bottom + 1 ? [Number(one.innerText)] : [];
  });
});
const lines = async () => (await numbers()).length;
const top = () => page.locator('.code').evaluate((code) => Math.round(code.getBoundingClientRect().top));
const height = (selector) => page.locator(selector).first().evaluate((one) => Math.round(one.getBoundingClientRect().height));
const roomy = async () => {
  let found;
  await until(async () => (found = await crowding(page)).length === 0, () => found.join('\n'));
};

test('26 lines of program with status at 1280x800, 18 at 1024x768', async () => {
  await turn(page, 'RUN-P');
  await page.getByRole('switch', { name: 'Status' }).click();
  await page.locator('.code .cm-status-head').waitFor();
  await expect(() => page.locator('.note').count(), 0, 'notes');
  for (const [width, height, wanted] of [[1280, 800, 26], [1024, 768, 18]]) {
    await page.setViewportSize({ width, height });
    let seen;
    await until(async () => (seen = await lines()) >= wanted, () => `${wanted} lines at ${width}x${height}, seen ${seen}`);
    await accessible(page, `program at ${width}x${height}`);
    await roomy();
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  // What appears when something is typed takes none of them, and moves nothing.
  const before = await top();
  await toLine(page, 1);
  await page.keyboard.type('/');
  await page.locator('.note').waitFor();
  let left;
  await until(async () => (left = await lines()) >= 26, () => `26 lines with a note, seen ${left}`);
  assert.equal(await top(), before);
  await page.keyboard.press('Control+z');
  await expect(() => page.locator('.note').count(), 0, 'notes');
});

/** FC 1 stops the CPU in line 86, OB 1 begins in line 130. */
const FAULTY = `FUNCTION FC 1 : VOID
BEGIN
NETWORK
${'      U     E 0.0;\n'.repeat(80)}
      L     MW 20;
      BTI   ;
${'      U     E 0.0;\n'.repeat(40)}
END_FUNCTION

ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FC 1;
END_ORGANIZATION_BLOCK
`;

test('26 lines after a STOP as well: its bar is one line, also with a note; a chosen block stands at the top', async () => {
  const folder = join(server.workspace, 'faulty');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[project]\nname = "Faulty"\n');
  writeFileSync(join(folder, 'main.awl'), FAULTY);
  const look = await open(await launch(folder, server.workspace), 'program?file=main.awl');
  await turn(look, 'RUN-P');
  await look.getByRole('switch', { name: 'Status' }).click();
  await write(look, { 'MW 20': 'W#16#FFFF' });
  const bar = look.getByRole('status').filter({ hasText: 'STOP in FC 1, Zeile 86' });
  await bar.waitFor();
  const block = async (id, line) => {
    await look.getByRole('treeitem', { name: new RegExp(`^${id}\\b`) }).click();
    await expect(async () => (await numbers(look))[0], line, `the first line in sight of ${id}`);
  };
  const roomyBar = async (words) => {
    for (const [width, height, wanted] of [[1280, 800, 26], [1024, 768, 18], [768, 1024, 18]]) {
      await look.setViewportSize({ width, height });
      await until(async () => (await bar.evaluate((one) => one.offsetHeight)) <= 26, `one line at ${width}`);
      const end = words.includes('OB 1') ? 5 : wanted;
      let seen;
      await until(async () => (seen = (await numbers(look)).length) >= end, () => `${end} lines of ${words} at ${width}, seen ${seen}`);
      await accessible(look, `STOP in ${words} at ${width}`);
    }
    await look.setViewportSize({ width: 1280, height: 800 });
  };
  await block('FC 1', 1);
  await roomyBar('FC 1');
  // What is cut off with dots is read in full by a screen reader, and under the pointer.
  assert.match(await bar.innerText(), /AKKU1 0000FFFF[^]*STW/);
  assert.match(await bar.getAttribute('title'), /AKKU1 0000FFFF\n[^]*STW/);
  await block('OB 1', 130);
  await until(async () => /nicht beobachtet oder nicht bearbeitet/.test(await bar.innerText()), 'why OB 1 has no status');
  assert.equal(await look.locator('.note').count(), 0, 'a line of its own for the note');
  await roomyBar('OB 1');
  await bar.getByRole('button', { name: 'Zur Anweisung' }).click();
  await until(async () => (await look.locator('.code .cm-activeLine').innerText()).includes('BTI'), 'the statement');
  await expect(async () => (await numbers(look)).indexOf(86) > 8, true, 'the statement in the middle');
  await expect(async () => (await numbers(look)).length, 26, 'whole lines');
});

test('above the networks nothing lies on anything, on a tablet as well', async () => {
  await toLine(page, 42);
  await page.keyboard.press('Control+1');
  await page.locator('[data-network]').first().waitFor();
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await roomy();
  }
  await page.keyboard.press('Control+2');
  await page.locator('.code .cm-status-head').waitFor();
});

test('the text stays where it is while the cursor walks, with its declarations or without', async () => {
  const walked = async () => {
    const tops = new Set();
    for (const line of [1, 40, 120, 200, 5]) {
      await toLine(page, line);
      await expect(() => page.locator('.code .cm-lineNumbers .cm-activeLineGutter').innerText(), String(line));
      tops.add(await top());
    }
    return tops.size;
  };
  assert.equal(await walked(), 1);
  await toLine(page, 40);
  await page.locator('.work .head button').first().click();
  await page.getByRole('region', { name: 'Deklaration' }).waitFor();
  assert.equal(await walked(), 1);
  await accessible(page, 'declarations');
});

test('edges move with the keyboard and the pointer, and are remembered', async () => {
  await edge('Höhe der Deklaration').focus();
  const before = await height('.declarations');
  await page.keyboard.press('ArrowDown');
  await expect(() => height('.declarations'), before + 20);
  await edge('Breite der Liste').focus();
  await page.keyboard.press('Home');
  await expect(() => edge('Breite der Liste').getAttribute('aria-valuenow'), '140');
  const drawer = await edge('Höhe der Meldungen').boundingBox();
  await page.mouse.move(drawer.x + 200, drawer.y + 3);
  await page.mouse.down();
  await page.mouse.move(drawer.x + 200, drawer.y - 97, { steps: 4 });
  await page.mouse.up();
  await expect(() => height('#program-panel'), 126);
  const before3 = await top();
  await button('Meldungen und Ergebnisse').click();
  await expect(() => page.locator('#program-panel').isVisible(), false);
  assert.equal(await top(), before3, 'the drawer pushes the text');
  await page.reload();
  await page.locator('[data-phase="open"]').waitFor();
  await expect(() => edge('Breite der Liste').getAttribute('aria-valuenow'), '140');
  await expect(() => height('.declarations'), before + 20);
  assert.equal(await page.locator('#program-panel').isVisible(), false);
  // What is asked for opens the drawer.
  await page.getByRole('tab', { name: 'Referenzdaten' }).click();
  await page.getByLabel('Operand oder Symbol').waitFor();
  await page.getByRole('tab', { name: /^Fehler/ }).click();
  await edge('Höhe der Meldungen').dblclick();
  await expect(() => height('#program-panel'), 26);
});

test('the list is folded away; the program alone has the whole page', async () => {
  await page.locator('.work .head button').first().click();
  const seen = await lines();
  await button('Liste der Bausteine und Dateien').click();
  await expect(() => page.getByRole('tree').isVisible(), false);
  await page.keyboard.press('Alt+F10');
  await expect(() => page.locator('header nav').count(), 0);
  let whole;
  await until(async () => (whole = await lines()) >= seen + 2, () => `${seen + 2} lines, seen ${whole}`);
  await accessible(page, 'program alone');
  await roomy();
  await page.keyboard.press('Alt+F10');
  await page.locator('header nav').waitFor();
  await button('Liste der Bausteine und Dateien').click();
  await page.getByRole('tree').waitFor();
});

test('heads of views are one line', async () => {
  for (const [width, views] of [[1280, ['projects', 'symbols', 'io', 'variables', 'process', 'trends', 'hardware', 'diagnosis']], [1024, ['symbols', 'process', 'hardware']]]) {
    await page.setViewportSize({ width, height: 800 });
    for (const view of views) {
      await visit(page, server, view);
      await page.locator(`nav a[href="#/${view}"][aria-current]`).waitFor();
      await expect(async () => (await height('.view-head')) <= 44, true, `${view} at ${width}`);
    }
  }
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('rows of tables are dense, with room for fingers on demand', async () => {
  const rows = {
    program: () => height('[role=treeitem]'),
    symbols: () => height('.table tbody tr'),
    variables: () => height('.table tbody tr'),
  };
  for (const [view, row] of Object.entries(rows)) {
    await visit(page, server, view);
    await page.locator(view === 'program' ? '[role=treeitem]' : '.table tbody tr').first().waitFor();
    const dense = await row();
    assert.ok(dense >= 22 && dense <= 26, `${view}: ${dense} px`);
    await accessible(page, `${view}, dense`);
  }
  const finger = async () => {
    await page.keyboard.press('F1');
    await page.getByRole('switch', { name: 'Finger' }).click();
    await leave(page);
  };
  await visit(page, server, 'symbols');
  await page.locator('.table tbody tr').first().waitFor();
  await finger();
  await until(async () => (await rows.symbols()) >= 40, 'rows for a finger');
  await finger();
  await until(async () => (await rows.symbols()) <= 26, 'dense rows');
  await visit(page, server, 'program?file=sorting.awl');
  await page.locator('.code').waitFor();
});

test('the rack and its catalogue are as dense', async () => {
  await visit(page, server, 'hardware?mode=plan');
  await page.getByText('Digital', { exact: false }).first().click();
  const seen = () => page.getByRole('region', { name: 'Katalog' }).locator('.list').evaluate((list) => {
    const { top, bottom } = list.getBoundingClientRect();
    return [...list.querySelectorAll('li')].map((one) => one.getBoundingClientRect()).filter((one) => one.height > 0 && one.top >= top && one.bottom <= bottom).length;
  });
  await until(async () => (await seen()) >= 12, 'twelve modules of the catalogue');
  for (const row of ['tr[data-slot="4"]', '[aria-label="Katalog"] .list details[open] li']) {
    const high = await height(row);
    assert.ok(high >= 22 && high <= 26, `${row}: ${high} px`);
  }
  await visit(page, server, 'io');
  await page.locator('[data-operand="E 0.0"]').waitFor();
  assert.equal(await height('[data-operand="E 0.0"]'), 24);
  await visit(page, server, 'program?file=sorting.awl');
  await page.locator('.code').waitFor();
});

test('nothing in the bar of the text is cut off on a tablet; it has two lines, the tabs of the drawer one', async () => {
  // The arrow of a choice takes 18 px.
  const cut = () => page.locator('.work .bar select').evaluateAll((all) => all.filter((one) => {
    const style = getComputedStyle(one);
    const pen = document.createElement('canvas').getContext('2d');
    pen.font = style.font;
    return pen.measureText(one.selectedOptions[0].textContent).width > one.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - 18;
  }).length);
  const overfull = () => page.locator('.work .bar button').evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent).join());
  const named = () => page.locator('.work .bar .path').evaluate((one) => one.clientWidth > 0 && one.scrollWidth <= one.clientWidth);
  await page.setViewportSize({ width: 1024, height: 768 });
  await expect(cut, 0, 'choices that are cut off at 1024');
  await expect(overfull, '', 'buttons that are too narrow for their words');
  await expect(named, true, 'the whole name of the file');
  assert.ok((await height('.work .bar')) <= 76, 'two lines at 1024');
  await page.setViewportSize({ width: 768, height: 1024 });
  const lines = () => page.locator('.panel [role=tab]').evaluateAll((tabs) => new Set(tabs.map((tab) => tab.offsetTop)).size);
  await expect(lines, 1);
  await expect(async () => (await height('.work .bar')) <= 76, true, 'two lines');
  await expect(cut, 0, 'choices that are cut off at 768');
  await expect(named, true, 'the whole name of the file at 768');
  await roomy();
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('on a tablet held upright the list stands above the text, which has the whole width', async () => {
  await page.setViewportSize({ width: 768, height: 1024 });
  const wide = () => page.locator('.code').evaluate((code) => code.getBoundingClientRect().width);
  await until(async () => (await wide()) >= 740, 'the width of the page');
  const list = await page.locator('.side').boundingBox();
  assert.ok(list.y + list.height <= (await top()), 'the list is above the text');
  await page.getByRole('tree').getByRole('treeitem').nth(2).waitFor();
  await edge('Höhe der Liste').press('End');
  await expect(() => page.locator('.side').evaluate((side) => side.offsetHeight), 480);
  await edge('Höhe der Liste').dblclick();
  await accessible(page, 'list above the text');
  await roomy();
  const seen = await lines();
  await button('Liste der Bausteine und Dateien').click();
  await until(async () => (await lines()) >= seen + 8, 'the room of the list');
  await button('Liste der Bausteine und Dateien').click();
  await page.setViewportSize({ width: 1280, height: 800 });
  await edge('Breite der Liste').waitFor();
});

test('HALT leaves the text where it is', async () => {
  const before = await top();
  await toLine(page, 47);
  await page.keyboard.press('F9');
  await page.locator('[data-mode="HALT"]').waitFor();
  await page.getByText('F10').waitFor();
  assert.equal(await top(), before);
  assert.ok((await lines()) >= 20, `${await lines()} lines`);
  // One line of steps, and one of the front plate, on a tablet.
  for (const [width, high] of [[1024, 768], [768, 1024]]) {
    await page.setViewportSize({ width, height: high });
    await until(async () => (await height('.halt .bar')) <= 40, `one line at ${width}`);
    await roomy();
    const fold = page.getByRole('button', { name: 'Frontplatte der CPU' });
    if (width < 900) await until(async () => (await fold.boundingBox()).x + 32 <= width, 'the button that unfolds the front plate');
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  // The cursor stands at the breakpoint: it goes, and so does the CPU.
  await page.keyboard.press('F9');
  await page.locator('.halt').getByRole('button', { name: 'F8' }).click();
  await page.locator('[data-mode="RUN"]').waitFor();
  assert.equal(await top(), before);
});

test('on a tablet held upright the front plate of the CPU is one row until it is unfolded', async () => {
  const tablet = await open(server, 'io', { width: 768, height: 1024 });
  const high = () => tablet.locator('aside[aria-label="CPU"]').evaluate((plate) => plate.getBoundingClientRect().height);
  await until(async () => (await high()) <= 48, 'one row');
  await tablet.getByRole('status', { name: 'Betriebszustand' }).waitFor();
  assert.equal(await tablet.getByRole('radio', { name: 'STOP' }).count(), 0);
  await accessible(tablet, 'folded');
  await tablet.getByRole('button', { name: 'Frontplatte der CPU' }).press('Enter');
  await turn(tablet, 'STOP');
  await turn(tablet, 'RUN-P');
  await tablet.reload();
  await until(async () => (await high()) > 100, 'it stays unfolded');
  await tablet.getByRole('button', { name: 'Frontplatte der CPU' }).press('Enter');
  await until(async () => (await high()) <= 48, 'one row again');
});

test('an error hides nothing: all of the row that is worked at stays in sight', async () => {
  const look = await open(server, 'program?file=sorting.awl&line=200');
  await look.getByRole('tab', { name: 'Beobachten' }).click();
  const rows = look.locator('#program-panel tbody tr:has(input:enabled)');
  await rows.first().waitFor();
  const field = rows.last().locator('input');
  /** What lies over one of its cells. */
  const over = () => rows.last().evaluate((row) => [...row.cells].flatMap((cell) => {
    const { left, top, height } = cell.getBoundingClientRect();
    const found = document.elementFromPoint(left + 12, top + height / 2);
    return left > innerWidth - 20 || row.contains(found) ? [] : [`${cell.textContent.trim() || cell.className} is under ${found?.closest('.message')?.className ?? found?.className}`];
  }));
  for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) {
    await look.setViewportSize({ width, height });
    await quiet(look);
    await rows.last().scrollIntoViewIfNeeded();
    await field.fill('nothing');
    await field.press('Enter');
    await look.locator('.message.problem').first().waitFor();
    let hidden;
    await until(async () => (hidden = await over()).length === 0, () => `${width}x${height}: ${hidden.join(', ')}`);
    await accessible(look, `an error at ${width}x${height}`);
  }
});
