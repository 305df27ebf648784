// Elements and networks of KOP and FUP are copied, cut, pasted and moved (S7-EDIT-13, -15).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { text } from './editor.mjs';
import { expect, message, open } from './harness.mjs';
import { networksOf, OF, project } from './networks.mjs';

const plc = await project('314C-2 PtP', 'main.awl', OF(['U E 0.0;', '= A 1.0;']));
const page = await open(plc, 'program?file=main.awl', { height: 720 });
await page.context().grantPermissions(['clipboard-read', 'clipboard-write'], { origin: new URL(plc.address).origin });
const { press, network, elements, statements, inside, marked, drawn } = networksOf(page);
const at = (label) => page.locator(`.networks [aria-label="${label}"]`).first();
const TWO = OF(['U E 0.0;', 'U E 0.1;', '= A 1.0;'], 'NETWORK\nTITLE = Second\n      U     E 1.0;\n      =     A 1.1;\n');

test('an element is copied into another network, as AWL', async () => {
  await drawn('kop', TWO);
  await at('Schließerkontakt E 0.1').click();
  await press('Control+c');
  await expect(() => page.evaluate(() => navigator.clipboard.readText().then((text) => text.trim().replace(/\s+/g, ' '))), 'U E 0.1;');
  await at('Schließerkontakt E 1.0').click();
  await press('Control+v');
  await expect(statements, 'U E 0.0; U E 0.1; = A 1.0; U E 1.0; U E 0.1; = A 1.1;');
  await inside();
  await press('Control+z');
  await expect(statements, 'U E 0.0; U E 0.1; = A 1.0; U E 1.0; = A 1.1;');
});

test('an element is cut and pasted before the first one, as fast as one types', async () => {
  await at('Schließerkontakt E 0.1').click();
  await press('Control+x', 'ArrowLeft', 'ArrowLeft', 'Control+v');
  await expect(statements, 'U E 0.1; U E 0.0; = A 1.0; U E 1.0; = A 1.1;');
});

test('at its title a whole network is copied', async () => {
  await network(2).locator('[data-head]').click();
  await press('Control+c');
  await network(1).locator('[data-head]').click();
  await press('Control+v');
  await expect(() => page.locator('[data-network]').count(), 3);
  await expect(() => elements(2), 'Schließerkontakt E 1.0 | Spule =, A 1.1');
  assert.equal((await text(page)).match(/TITLE = Second/g).length, 2);
  await inside();
  await press('Control+x');
  await expect(() => page.locator('[data-network]').count(), 2);
});

test('what cannot be there is refused with a sentence, and nothing changes', async () => {
  const before = await text(page);
  await page.evaluate(() => navigator.clipboard.writeText('no statements at all'));
  await at('Schließerkontakt E 1.0').click();
  await press('Control+v');
  await page.locator('.message').first().waitFor();
  assert.equal(await text(page), before);
  await inside();
});

async function drag(from, to) {
  const middle = async (locator) => {
    const { x, y, width, height } = await locator.boundingBox();
    return [x + width / 2, y + height / 2];
  };
  await page.mouse.move(...(await middle(from)));
  await page.mouse.down();
  await page.mouse.move(...(await middle(to)), { steps: 5 });
  await page.mouse.up();
}

test('an element is moved with the mouse, also behind a group of branches', async () => {
  await drawn('kop', OF(['U E 0.0;', 'O E 0.1;', '= A 1.0;'], 'NETWORK\n      U     E 1.0;\n      U     E 1.1;\n      =     A 1.1;\n'));
  await drag(at('Schließerkontakt E 1.1'), at('Leitung hinter den Zweigen'));
  await expect(statements, 'U(; O E 0.0; O E 0.1; ); U E 1.1; = A 1.0; U E 1.0; = A 1.1;');
  await inside();
});

test('a network is moved by its title', async () => {
  await drawn('kop', TWO);
  await drag(network(1).locator('[data-head]'), network(2).locator('[data-head]'));
  await expect(() => elements(1), 'Schließerkontakt E 1.0 | Spule =, A 1.1');
  await expect(() => elements(2), 'Schließerkontakt E 0.0 | Schließerkontakt E 0.1 | Spule =, A 1.0');
});

test('a mark behind the branches takes the next contact', async () => {
  await drawn('kop', OF(['U E 0.0;', 'O E 0.1;', '= A 1.0;']));
  await at('Leitung hinter den Zweigen').click();
  await press('F2', ...'E 0.7', 'Enter');
  await expect(statements, 'U(; O E 0.0; O E 0.1; ); U E 0.7; = A 1.0;');
});
