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
