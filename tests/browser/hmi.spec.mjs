// Pictures that people draw: inserted, bound, moved, saved in the project, operated full screen (S7-VIS-01).
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, launch, message, open, scratch, turn, until, write } from './harness.mjs';
import { crowding } from './layout.mjs';

const PROGRAM = `ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     M 0.0;
      =     A 0.0;
END_ORGANIZATION_BLOCK
`;
const workspace = scratch();
const project = join(workspace, 'press');
mkdirSync(project);
writeFileSync(join(project, 'merker.toml'), '[project]\nname = "Press"\n');
writeFileSync(join(project, 'main.awl'), PROGRAM);
writeFileSync(join(project, 'main.sym'), '"Level"  MW 10  INT\n"Motor on"  A 0.0  BOOL\n');
const server = await launch(project, workspace);
const page = await open(server, 'process');
const file = () => readFileSync(join(project, 'Presse.hmi'), 'utf-8');
const saved = (line) => until(() => file().split('\n').includes(line), () => `${line} in\n${file()}`);
const insert = (kind) => page.getByRole('toolbar', { name: 'Symbole zum Einfügen' }).getByRole('button', { name: kind, exact: true }).press('Enter');
const set = async (label, value) => {
  const field = page.getByRole('region', { name: 'Eigenschaften' }).getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press('Enter');
};
const item = (kind, on = page) => on.locator(`[data-item=${kind}]`);
const grip = (kind) => item(kind).getByRole('button');

test('a picture of the project begins empty', async () => {
  await turn(page, 'RUN-P');
  await page.getByRole('button', { name: 'Bilder …' }).press('Enter');
  await page.getByText('Dieses Projekt hat noch kein Bild.').waitFor();
  await page.getByRole('button', { name: 'Neues Bild …' }).press('Enter');
  await page.getByLabel('Name').fill('Presse');
  await page.keyboard.press('Enter');
  await page.getByRole('toolbar', { name: 'Symbole zum Einfügen' }).waitFor();
  await accessible(page, 'empty picture');
});

test('symbols are inserted, bound and moved with the keyboard; each change is saved', async () => {
  await insert('Behälter');
  await set('Operand oder Symbol', '"Level"');
  await set('Beschriftung', 'Öl');
  await set('Voll bei', '200');
  await saved('tank ; 20 ; 20 ; 90 ; 140 ; "Level" ; Öl ; 0 ; 200');
  await insert('Motor');
  await set('Operand oder Symbol', '"Motor on"');
  await grip('motor').focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Shift+ArrowRight');
  await saved('motor ; 130 ; 30 ; 70 ; 60 ; "Motor on"');
  await page.keyboard.press('Control+z');
  await saved('motor ; 130 ; 30 ; 60 ; 60 ; "Motor on"');
  for (const [kind, operand] of [['Taster', 'M 0.0'], ['Zahl', 'MW 10'], ['Lampe', 'A 0.0'], ['Balken', 'MW 10'], ['Band', 'A 0.0'], ['Ventil', 'A 0.0']]) {
    await insert(kind);
    await set('Operand oder Symbol', operand);
  }
  await insert('Lampe');
  await grip('lamp').last().focus();
  await page.keyboard.press('Delete');
  await expect(() => item('lamp').count(), 1);
  await accessible(page, 'picture being edited');
});

test('a symbol is dragged to its place', async () => {
  const box = await grip('lamp').boundingBox();
  const before = /lamp ; (\d+) ; (\d+)/.exec(file());
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2 + 120, { steps: 4 });
  await page.mouse.up();
  await until(() => {
    const [, x, y] = /lamp ; (\d+) ; (\d+)/.exec(file());
    return x === before[1] && Number(y) >= Number(before[2]) + 60;
  }, 'another place');
});

test('in operation it shows what the operands have, full screen at an address of its own', async () => {
  const panel = await open(server, 'pictures?file=Presse.hmi&full=1', { width: 1024, height: 768 });
  await write(page, { 'MW 10': 50 });
  await expect(() => item('tank', panel).getAttribute('data-value'), '50');
  await until(() => panel.locator('[data-item=tank] .fill').evaluate((fill) => Math.abs(fill.getAttribute('height') - 33) < 1), 'a quarter full');
  assert.equal(await panel.locator('header nav').count(), 0);
  await panel.getByRole('button', { name: 'M 0.0' }).focus();
  await panel.keyboard.down('Space');
  await expect(() => item('lamp', panel).getAttribute('data-value'), '1');
  await panel.locator('.state.on').first().waitFor();
  await panel.keyboard.up('Space');
  await expect(() => item('lamp', panel).getAttribute('data-value'), '0');
  await expect(() => panel.locator('[data-item=motor] .caption').innerText(), 'Motor on');
  await expect(() => panel.locator('[data-item=lamp] .caption').innerText(), 'Motor on');
  await expect(() => panel.locator('[data-item=tank] .caption').innerText(), 'Öl');
  const field = panel.getByLabel('Neuer Wert von MW 10');
  await field.fill('-7');
  await field.press('Enter');
  await expect(() => item('number', panel).getAttribute('data-value'), '-7');
  for (const [width, height] of [[768, 1024], [1280, 800], [1024, 768]]) {
    await panel.setViewportSize({ width, height });
    await accessible(panel, `picture, ${width}`);
    let found;
    await until(async () => (found = await crowding(panel)).length === 0, () => found.join('\n'));
  }
  await panel.keyboard.press('Escape');
  await panel.locator('header nav').waitFor();
  await panel.context().close();
});

test('a picture that has not been read yet cannot be changed', async () => {
  const late = await open(server, 'process');
  let asked = null;
  let answer = null;
  await late.routeWebSocket(/./, (socket) => {
    const plc = socket.connectToServer();
    socket.onMessage((message) => {
      const { id, do: method, path } = JSON.parse(message);
      if (method === 'files.read' && path.endsWith('.hmi')) asked = id;
      plc.send(message);
    });
    plc.onMessage((message) => {
      if (JSON.parse(message).id !== asked) socket.send(message);
      else answer = () => socket.send(message);
    });
  });
  await late.reload();
  await late.getByRole('button', { name: 'Bilder …' }).press('Enter');
  await until(() => answer, 'the answer, which is kept back');
  await late.getByRole('switch', { name: 'Bearbeiten' }).press('Space');
  assert.equal(await late.getByRole('toolbar', { name: 'Symbole zum Einfügen' }).count(), 0);
  answer();
  await late.getByRole('toolbar', { name: 'Symbole zum Einfügen' }).waitFor();
  await late.context().close();
});

test('without a caption a symbol is called as its operand in the words of the page', async () => {
  writeFileSync(join(project, 'Presse.hmi'), 'button ; 20 ; 20 ; 110 ; 50 ; E 124.0\nlamp ; 200 ; 20 ; 40 ; 40 ; A 4.1\n');
  const english = await open(server, 'pictures?file=Presse.hmi&full=1', { language: 'en' });
  await english.getByRole('button', { name: 'I 124.0' }).waitFor();
  await expect(() => item('lamp', english).innerText(), 'Q 4.1');
  await english.getByRole('img', { name: 'Lamp Q 4.1: 0' }).waitFor();
  await english.context().close();
});

test('what another browser draws is seen; a line that is no symbol is named', async () => {
  writeFileSync(join(project, 'Presse.hmi'), 'tank ; 20 ; 20 ; 90 ; 140 ; MW 10\nwheel ; 1 ; 2 ; 3 ; 4\n');
  await page.getByText('Zeile 2 der Datei ist kein Symbol.').waitFor();
  await expect(() => page.locator('[data-item]').count(), 1);
});

test('a copy comes to the back; comments of the file stay', async () => {
  writeFileSync(join(project, 'Presse.hmi'), '// Drawn by Anna\nnumber ; 20 ; 20 ; 50 ; 40 ; MD 20\n// end\n');
  await expect(() => page.locator('[data-item]').count(), 1);
  await grip('number').focus();
  await page.keyboard.press('Control+d');
  await expect(() => page.locator('[data-item]').count(), 2);
  await page.getByRole('button', { name: 'Nach hinten' }).press('Enter');
  await until(() => /\nnumber ; 40 ; 40 .*\n\/\/ Drawn by Anna\nnumber ; 20 ; 20 .*\n\/\/ end\n$/.test(file()), file);
});

test('a number is never cut; one that is refused is marked', async () => {
  const panel = await open(server, 'pictures?file=Presse.hmi&full=1', { width: 1024, height: 768 });
  await write(page, { 'MD 20': 'L#-2147483647' });
  const field = panel.getByLabel('Neuer Wert von MD 20').first();
  await expect(() => field.inputValue(), '-2147483647');
  const cut = () => field.evaluate(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth);
  await expect(cut, false);
  await field.fill('abc');
  await field.press('Enter');
  await expect(() => field.getAttribute('aria-invalid'), 'true');
  await message(panel, /MD 20: .*abc/);
  await field.fill('5');
  await field.press('Enter');
  await expect(() => field.getAttribute('aria-invalid'), null);
});

/** Lamps in a picture that is edited; what the file has of each: x,y. */
async function lamps(...places) {
  writeFileSync(join(project, 'Presse.hmi'), places.map(([x, y]) => `lamp ; ${x} ; ${y} ; 40 ; 40 ; A 0.0\n`).join(''));
  await until(async () => (await item('lamp').count()) === places.length && (await item('number').count()) === 0, 'the lamps');
}
const placesOf = () => [...file().matchAll(/^lamp ; (\d+) ; (\d+)/gm)].map(([, x, y]) => `${x},${y}`).join(' ');
const chosen = () => page.locator('.grip[aria-pressed="true"]').count();
const lamp = (index) => grip('lamp').nth(index);
const properties = page.getByRole('region', { name: 'Eigenschaften' });

test('several symbols are chosen, moved, aligned, copied and deleted with the keyboard', async () => {
  await lamps([100, 100], [200, 150], [300, 300]);
  await lamp(0).focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('Tab');
  await expect(chosen, 1, 'the first one stays chosen');
  await page.keyboard.press('Space');
  await expect(chosen, 2);
  await properties.getByRole('heading', { name: '2 Symbole' }).waitFor();
  await page.keyboard.press('ArrowRight');
  await expect(placesOf, '110,100 210,150 300,300');
  await page.keyboard.press('Control+z');
  await expect(placesOf, '100,100 200,150 300,300');
  await accessible(page, 'two symbols chosen');
  await properties.getByRole('button', { name: 'Oben ausrichten' }).press('Enter');
  await expect(placesOf, '100,100 200,100 300,300');
  await properties.getByRole('button', { name: 'Links ausrichten' }).press('Enter');
  await expect(placesOf, '100,100 100,100 300,300');
  await page.keyboard.press('Control+z');
  await lamp(1).focus();
  await expect(chosen, 2, 'the focus chooses nothing else');
  await page.keyboard.press('Control+c');
  await page.keyboard.press('Control+v');
  await expect(placesOf, '100,100 200,100 300,300 120,120 220,120');
  await expect(chosen, 2);
  await page.keyboard.press('ArrowDown');
  await expect(placesOf, '100,100 200,100 300,300 120,130 220,130');
  await page.keyboard.press('Delete');
  await expect(placesOf, '100,100 200,100 300,300');
  await page.keyboard.press('Control+a');
  await expect(chosen, 3);
  await page.keyboard.press('Escape');
  await expect(chosen, 1);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await expect(placesOf, '');
  await page.keyboard.press('Control+z');
  await expect(placesOf, '100,100 200,100 300,300');
});

test('with the mouse: Ctrl and Shift click, a frame, all of them dragged', async () => {
  await lamps([100, 100], [200, 150], [600, 300]);
  const stage = await page.getByRole('group', { name: 'Bild' }).boundingBox();
  const scale = stage.width / 960;
  const at = (x, y) => [stage.x + x * scale, stage.y + y * scale];
  const drag = async (from, to) => {
    await page.mouse.move(...at(...from));
    await page.mouse.down();
    await page.mouse.move(...at(...to), { steps: 4 });
    await page.mouse.up();
  };
  await lamp(0).click();
  await expect(chosen, 1);
  await lamp(2).click({ modifiers: ['Control'] });
  await lamp(1).click({ modifiers: ['Shift'] });
  await expect(chosen, 3);
  await lamp(2).click({ modifiers: ['Control'] });
  await expect(chosen, 2);
  await drag([120, 120], [160, 150]);
  await expect(placesOf, '140,130 240,180 600,300');
  await expect(chosen, 2);
  await lamp(1).click();
  await expect(chosen, 1, 'a click chooses one');
  await drag([700, 400], [220, 160]);
  await expect(chosen, 2, 'those in the frame');
  await drag([20, 20], [30, 30]);
  await expect(chosen, 0, 'beside all symbols');
  await drag([20, 20], [300, 240]);
  await expect(async () => (await properties.getByRole('heading').innerText()), '2 Symbole');
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await accessible(page, `two symbols, ${width}`);
    let found;
    await until(async () => (found = await crowding(page)).length === 0, () => found.join('\n'));
  }
});

test('after aligning the arrow keys move the symbols; a button without a text is seen', async () => {
  await lamps([20, 20], [100, 60]);
  await lamp(0).focus();
  await page.keyboard.press('Control+a');
  await page.getByRole('button', { name: 'Oben ausrichten' }).click();
  await expect(placesOf, '20,20 100,20');
  await page.keyboard.press('ArrowDown');
  await expect(placesOf, '20,30 100,30');
  await page.getByRole('button', { name: 'Nach vorn' }).click();
  await page.keyboard.press('ArrowRight');
  await expect(placesOf, '30,30 110,30');
  await insert('Taster');
  await expect(() => grip('button').innerText(), 'Taster');
});

const chooser = page.locator('.choice select');
const choose = async (name, text) => {
  writeFileSync(join(project, `${name}.hmi`), text);
  await until(() => chooser.locator('option').allInnerTexts().then((all) => all.includes(name)), name);
  await chooser.selectOption(`${name}.hmi`);
};
const valueOf = (operand) => page.locator(`[data-operand="${operand}"]`).first().getAttribute('data-value');

test('a number and a bar have a format of their own', async () => {
  await write(page, { 'MD 34': '3.75' });
  await choose('Zahl', 'number ; 20 ; 20 ; 150 ; 40 ; MD 34\nbar ; 200 ; 20 ; 30 ; 140 ; MD 34 ; ; 0 ; 10\n');
  await expect(() => valueOf('MD 34'), '1081081856');
  for (const kind of ['number', 'bar']) {
    await grip(kind).focus();
    await properties.getByLabel('Anzeigeformat').selectOption('REAL');
  }
  await expect(() => valueOf('MD 34'), '3,75');
  const filled = () => item('bar').locator('.fill').evaluate((one) => Math.round((one.height.baseVal.value / 136) * 1000));
  await expect(filled, 375, 'thousandths of the bar');
  const lines = () => readFileSync(join(project, 'Zahl.hmi'), 'utf-8').split('\n').slice(1, 3).join('|');
  await expect(lines, 'number ; 20 ; 20 ; 150 ; 40 ; MD 34 ;  ;  ;  ; REAL|bar ; 200 ; 20 ; 30 ; 140 ; MD 34 ;  ; 0 ; 10 ; REAL');
  await accessible(page, 'a format');
  await page.getByRole('switch', { name: 'Bearbeiten' }).press('Space');
  const field = page.getByLabel('Neuer Wert von MD 34');
  await field.fill('2,5');
  await field.press('Enter');
  await expect(() => valueOf('MD 34'), '2,5');
  await page.getByRole('switch', { name: 'Bearbeiten' }).press('Space');
  await item('bar').waitFor();
  await page.keyboard.press('Control+z');
  await expect(lines, 'number ; 20 ; 20 ; 150 ; 40 ; MD 34 ;  ;  ;  ; REAL|bar ; 200 ; 20 ; 30 ; 140 ; MD 34 ; ; 0 ; 10');
});

// The rows of src/tool/monitor/display_format.cpp.
const FITTING = {
  'MB 40': 'AUTO BIN HEX DEC UDEC BCD CHAR',
  'MW 42': 'AUTO BIN HEX DEC UDEC BCD CHAR S5TIME DATE COUNTER',
  'MD 44': 'AUTO BIN HEX DEC UDEC BCD CHAR REAL TIME TOD POINTER KG',
};

test('each format shows a value where it fits the operand, and a question mark where not', async () => {
  for (const [operand, fitting] of Object.entries(FITTING))
    for (const kind of ['number', 'bar']) {
      await choose(`${kind}${operand.slice(0, 2)}`, `${kind} ; 20 ; 20 ; 60 ; 140 ; ${operand} ; ; 0 ; 10\n`);
      await grip(kind).focus();
      const format = properties.getByLabel('Anzeigeformat');
      for (const name of await format.locator('option').evaluateAll((all) => all.map((one) => one.value))) {
        await format.selectOption(name);
        const wanted = fitting.split(' ').includes(name);
        await until(async () => ((await valueOf(operand)) !== '?') === wanted, () => `${name} of ${operand} in a ${kind}`);
      }
    }
});

test('a symbol that cannot be watched leaves the others', async () => {
  await write(page, { 'MW 200': 77 });
  await choose('Lang', `lamp ; 20 ; 20 ; 40 ; 40 ; ${'x'.repeat(450)}\nnumber ; 200 ; 20 ; 110 ; 40 ; MW 200\n`);
  await expect(() => valueOf('MW 200'), '77');
  await page.locator('.item.lamp.wrong[title*="400"]').waitFor();
});

test('a file that cannot be read shows why, and not the picture before', async () => {
  await choose('Null', 'lamp ; 20 ; 20 ; 40 ; 40 ; A 0.0\0\n');
  await page.getByText(/^Null\.hmi kann nicht gezeigt werden: /).waitFor();
  assert.equal(await page.locator('[data-item]').count(), 0);
  assert.equal(await page.getByRole('toolbar', { name: 'Symbole zum Einfügen' }).count(), 0);
  await accessible(page, 'unreadable picture');
  writeFileSync(join(project, 'Null.hmi'), 'lamp ; 20 ; 20 ; 40 ; 40 ; A 0.0\n');
  await item('lamp').waitFor();
});
