// Boxes and operands in KOP and FUP: calls with their pins, completion, what is typed where nothing can be (S7-EDIT-13, -15, -17).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { text } from './editor.mjs';
import { expect, message, open } from './harness.mjs';
import { holder, networksOf, OF, project } from './networks.mjs';

const FC = `FUNCTION FC 1 : VOID
VAR_INPUT
  start : BOOL;
  speed : INT;
END_VAR
VAR_OUTPUT
  done : BOOL;
END_VAR
BEGIN
NETWORK
      NOP 0;
END_FUNCTION
`;
const FB = `FUNCTION_BLOCK FB 1
VAR_INPUT
  first : INT;
  second : INT;
END_VAR
VAR_OUTPUT
  sum : INT;
END_VAR
BEGIN
NETWORK
      NOP 0;
END_FUNCTION_BLOCK
DATA_BLOCK DB 1
FB 1
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2
STRUCT
  level : INT;
END_STRUCT;
BEGIN
END_DATA_BLOCK
`;
const blocks = FC + FB;
const plc = await project('314C-2 PtP', 'main.awl', blocks + OF(['U E 0.0;', '= A 1.0;']));
const page = await open(plc, 'program?file=main.awl', { height: 720 });
const { press, network, field, elements, statements, inside, marked, operand, drawn } = networksOf(page);
const { hold, release } = holder(page);
const dialog = page.getByRole('dialog');
const call = async () => {
  await press('Alt+F9');
  // An edit may still be on its way: the palette opens behind it.
  await expect(() => page.evaluate(() => Boolean(document.activeElement?.closest('.palette'))), true);
  await press(...'call', 'Enter');
  await dialog.waitFor();
};

/** The field of the dialog that has the keyboard. */
const asked = (label) => expect(() => page.evaluate(() => document.activeElement?.labels?.[0]?.textContent), label);
const offers = (label) => dialog.getByRole('listbox').nth(label === 'Instanz-DB' ? 1 : 0).getByRole('option').locator('.mono').allInnerTexts();

test('a call asks for its block: it offers those there are, and refuses what is none', async () => {
  await drawn('kop', blocks + OF(['U E 0.0;', '= A 1.0;']));
  await press('Control+r');
  await expect(() => page.locator('[data-network]').count(), 2);
  await call();
  assert.deepEqual((await offers()).slice(0, 2).sort(), ['FB 1', 'FC 1']);
  await page.keyboard.type('Qx');
  await press('Enter');
  await dialog.getByText('Qx ist kein Baustein, der aufgerufen werden kann').waitFor();
  await asked('Baustein, z. B. FC 1');
  await accessible(page, 'call dialog');
  // What is typed next corrects it; Enter takes the first one that fits.
  await press(...'fb 1', 'Enter');
  await asked('Instanz-DB');
  await expect(() => dialog.getByRole('combobox').first().inputValue(), 'fb 1');
});

test('a call takes an instance of its function block, or a new one', async () => {
  assert.deepEqual(await offers('Instanz-DB'), ['DB 1', 'DB 3']);
  await press(...'db2', 'Enter');
  await dialog.getByText('db2 ist kein Instanz-DB von FB 1').waitFor();
  await asked('Instanz-DB');
  await press(...'db1', 'Enter');
  await expect(() => dialog.count(), 0);
  await field().waitFor();
  await press('Escape', 'Control+z');
  await expect(async () => (await statements()).includes('CALL'), false);
  // By Enter alone: a part of the name, then the instance that is offered first.
  await call();
  await press(...'fb', 'Enter');
  await asked('Instanz-DB');
  await press('Enter');
  await expect(() => dialog.count(), 0);
});

test('Enter goes through the open pins of a call', async () => {
  await operand('MW 10');
  await operand('MW 12');
  await operand('MW 14');
  await expect(async () => /CALL\s+FB 1\s*,\s*DB 1\s*\(\s*first\s*:= MW 10\s*,\s*second\s*:= MW 12\s*,\s*sum\s*:= MW 14/.test(await text(page)), true, 'the call');
  await expect(() => field().count(), 0);
  await inside();
  await network(2).locator('[aria-label="Box FB 1, DB 1"]').waitFor();
  await network(2).locator('[aria-label="first, Eingang von FB 1, DB 1: MW 10"]').waitFor();
});

test('the arrows go through the inputs in their order, then to the outputs, and across', async () => {
  await network(2).locator('[aria-label="Box FB 1, DB 1"]').focus();
  const pin = (side, name, operand) => `${name}, ${side} von FB 1, DB 1: ${operand}`;
  for (const label of [pin('Eingang', 'EN', 'offen'), pin('Eingang', 'first', 'MW 10'), pin('Eingang', 'second', 'MW 12'), pin('Ausgang', 'sum', 'MW 14')]) {
    await press('ArrowDown');
    await marked(label);
  }
  await press('ArrowLeft');
  await marked(pin('Eingang', 'first', 'MW 10'));
  await press('ArrowRight');
  await marked(pin('Ausgang', 'sum', 'MW 14'));
});

test('what is typed behind Alt+F9 while an edit is on its way goes to the palette', async () => {
  await drawn('kop', OF(['U E 0.0;', '= A 1.0;']));
  await hold();
  await press('Home', 'F3', ...'E 0.1', 'Enter', 'Alt+F9', ...'sr', 'Enter');
  await release();
  await operand('M 1.0');
  await expect(statements, 'U E 0.0; UN E 0.1; S M 1.0; U ??.?; R M 1.0; U M 1.0; = A 1.0;');
  assert.equal(await page.getByRole('searchbox', { name: 'Element suchen' }).inputValue(), '');
});

test('only what is missing has the frame of an error', async () => {
  await drawn('kop', blocks + OF(['CALL FC 1 (start := E 0.1, speed := ???, done := ??.?);', 'NOP 0;']));
  const framed = () => network().locator('.item.wrong').evaluateAll((all) => all.map((one) => one.getAttribute('aria-label')).join(' | '));
  await expect(framed, 'done, Ausgang von FC 1: ??.? | speed, Eingang von FC 1: ???');
});

const local = (statements) => OF(statements).replace('BEGIN', 'VAR_TEMP\n  ready : BOOL;\n  reading : BOOL;\n  level : INT;\nEND_VAR\nBEGIN');

test('Enter takes the name that is meant, without its sign too', async () => {
  await drawn('kop', local(['U E 0.0;', '= A 1.0;']));
  for (const [typed, taken] of [['#e', '#ready'], ['read', 'U read;'], ['reading', '#reading'], ['ready', '#ready'], ['E 0.5', 'E 0.5']]) {
    await network().locator('[data-node]').first().click();
    await press('Enter');
    await field().waitFor();
    if (typed === '#e') {
      await page.keyboard.type('#e');
      await expect(() => page.locator('.networks [role=option]').count(), 2);
      await press('ArrowDown', 'Enter');
    } else if (typed === 'read') {
      // Two begin so: nothing is guessed.
      await page.keyboard.type('read');
      await expect(() => page.locator('.networks [role=option]').count(), 2);
      await press('Escape');
      continue;
    } else await operand(typed);
    await expect(async () => (await statements()).includes(`U ${taken};`), true, typed);
  }
  await network().locator('[data-node]').first().click();
  await press('Enter');
  await operand('eadi');
  await expect(async () => (await statements()).includes('U #reading;'), true, 'the only offer');
});

test('a text that is refused stays in its field, wherever the keyboard went', async () => {
  await drawn('kop', OF(['L MW 2;', 'T MW 4;', 'NOP 0;']));
  await page.locator('[aria-label$="MW 2"]').click();
  await press(...'E 4.0', 'Tab');
  await message(page, 'dieser Operand darf hier nicht stehen');
  await expect(() => field().inputValue(), 'E 4.0');
  await press('Escape');
});

test('a text where there is no operand says so', async () => {
  await drawn('kop', OF(['NOP 0;']));
  await network().locator('[data-head]').focus();
  await press('E');
  await message(page, 'hier wird kein Operand eingegeben');
  assert.equal(await elements(), '');
});

test('LABEL of the palette opens the label of the network; a refused one stays in its field', async () => {
  await drawn('kop', OF(['U E 0.0;', 'SPB M001;'], 'NETWORK\n'));
  const label = (number = 2) => network(number).getByLabel('Sprungmarke');
  await network(2).locator('[data-head]').click();
  await press('Alt+F9', ...'label', 'Enter');
  await expect(() => label().evaluate((input) => input === document.activeElement), true);
  await network(2).getByLabel('Titel', { exact: true }).fill('Ende');
  await label().focus();
  await press(...'M00001', 'Enter');
  await message(page, 'eine Marke muss ein Buchstabe und höchstens drei weitere Buchstaben oder Ziffern sein');
  await expect(() => label().inputValue(), 'M00001');
  await expect(() => label().evaluate((input) => input === document.activeElement), true);
  assert.ok(!(await text(page)).includes('TITLE'), 'half of it was written');
  await press('Control+a', ...'M001', 'Enter');
  await expect(() => label().count(), 0);
  await inside();
  await expect(async () => (await text(page)).replace(/\s+/g, ' '), 'ORGANIZATION_BLOCK OB 1 BEGIN NETWORK U E 0.0; SPB M001; NETWORK TITLE = Ende M001: END_ORGANIZATION_BLOCK ');
  await network(2).locator('[data-head]').getByText('M001:').waitFor();
  // Its first element takes it.
  await press('F2');
  await operand('E 0.1');
  await press('F7');
  await operand('A 0.1');
  await expect(statements, 'U E 0.0; SPB M001; M001: U E 0.1; = A 0.1;');
});

test('LABEL is drawn onto a network as well', async () => {
  await drawn('fup', OF(['U E 0.0;', '= A 1.0;']));
  await page.locator('[data-element="LABEL"]').dragTo(network().locator('[data-node="1"]').first());
  await expect(() => network().getByLabel('Sprungmarke').evaluate((input) => input === document.activeElement), true);
  await press(...'END', 'Enter');
  await expect(statements, 'END: U E 0.0; = A 1.0;');
  await inside();
});
