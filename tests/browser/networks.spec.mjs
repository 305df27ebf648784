// Programs as KOP and FUP: shown, built with the keyboard alone, watched (S7-EDIT-08, -09, -13, -14, -15).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { content, replaceAll, text } from './editor.mjs';
import { expect, message, open, picture, serve, turn, until, visit, write } from './harness.mjs';
import { holder, networksOf, OF, project } from './networks.mjs';

const server = await serve('sorting-plant');
const page = await open(server, 'projects', { height: 720 });
const { press, network, field, elements, statements, inside, marked, operand, drawn } = networksOf(page);

async function newProject(name, view) {
  await visit(page, server, 'projects');
  await page.getByRole('button', { name: 'Neues Projekt …' }).click();
  await page.getByLabel('Projektname').fill(name);
  await page.getByLabel('Darstellung').selectOption(view);
  await page.getByRole('button', { name: 'Anlegen' }).click();
  // The project before stays on the page until this one has been read.
  await until(async () => (await page.title()).includes(name), 'the project');
  await page.getByRole('group', { name: view.toUpperCase(), exact: true }).waitFor();
  await network().waitFor();
  await expect(elements, '');
  await until(() => network().evaluate((card) => card.contains(document.activeElement)), 'the keyboard in the network');
}

const EXAMPLE = 'U E 0.0; U E 0.1; O A 1.0; = A 3.0;';

test('the worked example as ladder, with the keyboard alone (S7-EDIT-15)', async () => {
  await newProject('Kop', 'kop');
  await press('F2');
  await operand('E 0.0');
  await press('F2');
  await operand('E 0.1');
  await press('Home', 'F8');
  await operand('A 1.0');
  await press('F9', 'F7');
  await operand('A 3.0');
  await expect(statements, EXAMPLE);
  await expect(elements, 'Schließerkontakt E 0.0 | Schließerkontakt E 0.1 | Schließerkontakt A 1.0 | Spule =, A 3.0');
});

test('the same as function blocks, with the keyboard alone (S7-EDIT-13, -14)', async () => {
  await newProject('Fup', 'fup');
  await press('F2');
  await operand('E 0.0');
  await operand('E 0.1');
  await press('ArrowRight', 'F3');
  await operand('A 1.0');
  await press('F7');
  await operand('A 3.0');
  await expect(statements, EXAMPLE);
  await expect(elements, 'Box >=1 | Box & | Ausgang =, A 3.0 | Eingang E 0.0 | Eingang E 0.1 | Eingang A 1.0');
  await picture(page, 'networks-fup');
});

const undone = async (key, wanted) => (await press(key), expect(statements, wanted));

test('each edit is undone and done again by itself', async () => {
  await undone('Control+z', 'U E 0.0; U E 0.1; O A 1.0; = ??.?;');
  await undone('Control+z', 'U E 0.0; U E 0.1; O A 1.0;');
  await undone('Control+y', 'U E 0.0; U E 0.1; O A 1.0; = ??.?;');
  await undone('Control+y', EXAMPLE);
});

const symbols = () => network().locator('.symbol').evaluateAll((all) => all.map((one) => (one.classList.contains('on') ? 1 : one.classList.contains('off') ? 0 : '-')).join(''));
/** Each contact by itself, and the signal of the coil. */
const flow = (a, b, c) => [a, b, c, (a & b) | c].join('');

test('the signal flow has the status of each row of the truth table (S7-EDIT-14, S7-EDIT-21)', async () => {
  await press('Control+s');
  await message(page, 'main.awl gespeichert');
  await press('Control+l');
  await message(page, 'Programm geladen');
  await turn(page, 'RUN-P');
  await page.getByRole('button', { name: 'KOP', exact: true }).click();
  await page.getByRole('switch', { name: 'Status' }).click();
  for (let row = 0; row < 8; ++row) {
    const [a, b, c] = [row >> 2, (row >> 1) & 1, row & 1];
    await write(page, { 'E 0.0': a, 'E 0.1': b, 'A 1.0': c });
    await expect(symbols, flow(a, b, c), `row ${row}`);
  }
  await write(page, { 'E 0.1': 0 });
  await expect(symbols, '1011');
  await picture(page, 'networks-status');
});

test('all views show the same program: text and machine code stay as they are (S7-EDIT-08)', async () => {
  await page.getByRole('tab', { name: 'Maschinencode' }).click();
  const code = () => page.getByRole('table', { name: /^Maschinencode von / }).locator('tbody').innerText();
  await until(async () => /D883|A 3\.0/.test(await code()), 'the machine code');
  const [before, source] = [await code(), await text(page)];
  for (const [key, view] of [['2', 'AWL'], ['3', 'FUP'], ['1', 'KOP'], ['2', 'AWL'], ['1', 'KOP']]) {
    await press(`Control+${key}`);
    await expect(() => page.getByRole('button', { name: view, exact: true }).getAttribute('aria-pressed'), 'true');
    if (view === 'AWL') await content(page).waitFor();
    else await until(() => network().evaluate((card) => card.contains(document.activeElement)), 'the keyboard in the network');
    assert.equal(await text(page), source, view);
    await expect(code, before, view);
  }
});

test('a network that stays AWL names its statement (S7-EDIT-09)', async () => {
  await press('Control+2');
  await replaceAll(page, (await text(page)).replace('END_ORG', 'NETWORK\n      L     EB 1;\n      T     MB 1;\nEND_ORG'));
  await press('Control+1');
  await network(2).getByText(/^bleibt AWL: Zeile \d+: /).waitFor();
  await expect(() => network(2).locator('.blamed').innerText(), '      L     EB 1;');
  await press('Control+3');
  await network(2).getByText(/^bleibt AWL: /).waitFor();
});

test('a new network and elements from the palette: by its search, by dragging (S7-EDIT-13)', async () => {
  await press('Control+1');
  await network(1).locator('[data-head]').click();
  await press('Control+r');
  await expect(() => page.locator('[data-network]').count(), 3);
  await until(() => network(2).evaluate((card) => card.contains(document.activeElement)), 'the keyboard in the new network');
  await press('Alt+F9');
  await page.keyboard.type('s_impuls');
  await press('Enter');
  await operand('T 1');
  await operand('S5T#2S');
  await operand('E 1.0');
  await until(async () => /SI\s+T 1;/.test(await text(page)), () => 'the timer');
  const contact = page.locator('[data-element="CONTACT_NOT"]');
  // A mouse that lets go while the timer is still being put in drops it beside.
  await until(async () => {
    await contact.dragTo(network(1).locator('[data-node="0"]').first());
    for (let looks = 0; looks < 50 && (await field().count()) === 0; looks++) await page.waitForTimeout(100);
    return (await field().count()) > 0;
  }, 'the field of the contact');
  await operand('E 7.7');
  await expect(async () => (await statements()).slice(0, 18), 'U E 0.0; UN E 7.7;');
});
const { hold, release } = holder(page);

test('what is typed while an edit is on its way is for what the edit makes', async () => {
  for (const [view, place, made] of [['kop', 'Schließerkontakt E 0.1', 'U E 0.0; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 4.0;'], ['fup', 'R, Eingang von SR M 1.0: E 0.1', 'U E 0.0; S M 1.0; U E 0.1; R M 1.0; U M 1.0; = A 4.0;']]) {
    await drawn(view, OF(['U E 0.0;', 'S M 1.0;', 'U E 0.1;', 'R M 1.0;', 'NOP 0;']));
    await page.locator(`[aria-label="${place}"]`).click();
    await hold();
    await press('F7', ...'A 4.0', 'Enter');
    await release();
    await expect(statements, made, view);
    await inside();
  }
});

test('a coil without logic stays AWL with its reason; one put into an empty network has an open contact', async () => {
  for (const view of ['kop', 'fup']) {
    for (const bare of ['= A 3.0;', 'S A 3.0;', 'SAVE;']) {
      await drawn(view, OF(['U E 0.0;', '= A 3.1;'], `NETWORK\n      ${bare}\n`));
      await network(2).getByText('vor der Spule muss eine Verknüpfung stehen').waitFor();
      await expect(() => elements(2), '', bare);
    }
    await drawn(view, OF([]));
    await network().click();
    await press('F7');
    await operand('A 3.0');
    await expect(statements, 'U ??.?; = A 3.0;', view);
  }
});

test('a refused key says why, and the text typed behind it overwrites nothing', async () => {
  const before = 'U E 0.0; = A 1.0;';
  await drawn('kop', OF(['U E 0.0;', '= A 1.0;']));
  for (const slow of [true, false]) {
    await page.locator('[aria-label="Spule =, A 1.0"]').click();
    if (slow) await hold();
    await press('F8', ...(slow ? [...'E 4.0', 'Enter'] : []));
    if (slow) await release();
    await message(page, 'Netzwerk 1: hier darf kein Abzweig beginnen');
    await marked('Spule =, A 1.0');
    await press(...'E 4.0', 'Enter');
    assert.equal(await statements(), before);
    await marked('Spule =, A 1.0');
  }
  await press(...'A 2.0', 'Enter');
  await expect(statements, 'U E 0.0; = A 2.0;');
});

test('an operand that is refused can be mended where it was typed', async () => {
  await drawn('kop', OF(['L MW 2;', 'T MW 4;', 'NOP 0;']));
  await page.locator('[aria-label$="MW 2"]').click();
  await press(...'E 4.0', 'Enter');
  await message(page, 'dieser Operand darf hier nicht stehen');
  await expect(() => field().inputValue(), 'E 4.0');
  await press('Control+a');
  await operand('MW 6');
  await expect(statements, 'L MW 6; T MW 4; NOP 0;');
});

test('each action leaves the keyboard in the networks', async () => {
  await drawn('kop', OF(['U E 0.0;', 'U E 0.1;', '= A 1.0;'], 'NETWORK\n      U E 1.0;\n      = A 1.1;\n'));
  const at = async (keys, label) => (await press(...keys), await marked(label));
  await at(['Home'], 'Schließerkontakt E 0.0');
  await at(['Delete'], 'Schließerkontakt E 0.1');
  await at(['Control+z'], 'Schließerkontakt E 0.0');
  await at(['Control+y'], 'Schließerkontakt E 0.1');
  await at(['Control+z'], 'Schließerkontakt E 0.0');
  await press('Control+r');
  await expect(() => page.locator('[data-network]').count(), 3);
  await marked('network-2');
  await press('Control+Delete');
  await expect(() => page.locator('[data-network]').count(), 2);
  await inside();
  await press('Control+z');
  await expect(() => page.locator('[data-network]').count(), 3);
  await inside();
  await press('Control+z');
  await expect(() => page.locator('[data-network]').count(), 2);
  await inside();
  for (const key of ['Control+3', 'Control+1']) {
    await press('Control+2');
    await content(page).waitFor();
    await press(key);
    await inside();
  }
  await press('F2');
  await field().waitFor();
  await press('Escape');
  await inside();
});

test('the help lists the keys of KOP and FUP', async () => {
  await press('F1');
  const keys = page.getByRole('dialog');
  await keys.getByRole('heading', { name: 'Tasten in KOP und FUP' }).waitFor();
  await keys.getByText('KOP: Zweig weiter rechts schließen; FUP: Eingang negieren').waitFor();
  await press('Escape');
  await expect(() => page.getByRole('dialog').count(), 0);
});

test('in English, in the dark and on a phone: nothing is hidden, nothing is wider than the page', async () => {
  for (const [width, height, theme] of [[1280, 720, 'light'], [1280, 720, 'dark'], [390, 844, 'dark']]) {
    const other = await open(server, 'program?file=main.awl', { width, height, theme, language: 'en' });
    await other.getByRole('button', { name: 'LAD', exact: true }).click();
    await other.locator('[data-network="1"] [data-node]').first().waitFor();
    await accessible(other, `LAD, ${width} px, ${theme}`);
    const [wide, page] = await other.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(wide <= page, `${wide} px in ${page} px`);
    await other.context().close();
  }
});

test('of 500 networks only those in sight are drawn', async () => {
  const one = (_, i) => `NETWORK\nTITLE = Number ${i + 1}\n      U     M ${i % 100}.0;\n      =     M ${i % 100}.2;\n`;
  const plc = await project('314C-2 PtP', 'main.awl', `ORGANIZATION_BLOCK OB 1\nBEGIN\n${Array.from({ length: 500 }, one).join('')}END_ORGANIZATION_BLOCK\n`);
  const many = await open(plc, 'program?file=main.awl', { height: 720 });
  await many.getByRole('button', { name: 'KOP', exact: true }).click();
  await expect(() => many.locator('[data-network]').count(), 500);
  await until(async () => (await many.locator('.drawing').count()) > 1, 'drawings');
  assert.ok((await many.locator('.drawing').count()) < 50);
  const last = many.locator('[data-network="500"]');
  await last.scrollIntoViewIfNeeded();
  await last.locator('[data-node]').first().waitFor();
});

test('STEP 5: the worked example in a listing, with the keyboard alone', async () => {
  const control = await project('SINUMERIK 810 GA3', 'main.s5', 'OB 1\nNETZWERK 1  example\n : BE\n');
  const listing = await open(control, 'program?file=main.s5', { height: 720 });
  await listing.getByRole('button', { name: 'FUP', exact: true }).click();
  await listing.locator('[data-head="1"]').click();
  const type = async (name) => {
    await listing.locator('.networks input').waitFor();
    await listing.keyboard.type(name);
    await listing.keyboard.press('Enter');
  };
  const keys = async (...all) => { for (const key of all) await listing.keyboard.press(key); };
  await keys('F2');
  await type('E 0.0');
  await type('E 0.1');
  await keys('ArrowRight', 'F3');
  await type('A 1.0');
  await keys('F7');
  await type('A 3.0');
  const lines = async () => (await text(listing)).split('\n').filter((line) => line.startsWith(' :')).map((line) => line.trim().replace(/\s+/g, ' ')).join(' ');
  await expect(lines, ': U E 0.0 : U E 0.1 : O A 1.0 : = A 3.0 : BE');
  await listing.getByRole('button', { name: 'KOP', exact: true }).click();
  await listing.locator('[data-element="CONTACT"]').waitFor();
  const offered = (id) => listing.locator(`[data-element="${id}"]`).count();
  for (const none of ['NOT', 'P', 'N', 'POS', 'NEG']) assert.equal(await offered(none), 0, none);
  await listing.locator('[aria-label="Schließerkontakt A 1.0"]').click();
  await listing.locator('[data-element="SR"]').click();
  await message(listing, 'KOP kann das nicht darstellen: das Netzwerk wäre nur noch als FUP darstellbar');
  await expect(lines, ': U E 0.0 : U E 0.1 : O A 1.0 : = A 3.0 : BE');
  await listing.locator('[data-head="1"]').click();
  await keys('F2');
  await listing.locator('.networks input').waitFor();
  await keys('Escape');
  await listing.locator('#program-panel').getByText(/U braucht einen Operanden|U .*Operand/).first().waitFor();
});
