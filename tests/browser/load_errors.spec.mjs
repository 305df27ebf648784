// What the compiler refuses at "load" stands in the list of problems, once (S7-EDIT-06, S7-EDIT-07).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { problems, replaceAll } from './editor.mjs';
import { OF, project } from './networks.mjs';
import { expect, message, open, turn, until } from './harness.mjs';

const server = await project('generic', 'main.awl', OF(['L 1']));
const page = await open(server, 'program?file=main.awl', { stays: true });
const bars = () => page.locator('.messages .message.problem').count();
const load = () => page.locator('.bar').getByRole('button', { name: 'Laden', exact: true }).click();
const tab = (name) => page.getByRole('tab', { name });

test('a load with errors opens the list of problems and tells nothing twice', async () => {
  await turn(page, 'RUN-P');
  await replaceAll(page, OF(['UC FC 70', 'CALL FC 71', 'U #nowhere']));
  await tab('Referenzdaten').click();
  await load();
  await expect(() => tab(/^Fehler/).getAttribute('aria-selected'), 'true');
  await expect(() => problems(page).count(), 3);
  assert.equal(await bars(), 0, 'bars beside the list');
  // All of them in sight, the warning as such.
  const seen = await page.locator('#program-panel').boundingBox();
  const last = await problems(page).last().boundingBox();
  assert.ok(last.y + last.height <= seen.y + seen.height + 1, 'the last problem is in sight');
  assert.equal(await page.locator('#program-panel .sign.error').count(), 2);
});

test('a closed drawer opens as well; what has been mended is gone', async () => {
  await page.getByRole('button', { name: 'Meldungen und Ergebnisse', exact: true }).click();
  await expect(() => page.locator('#program-panel').isVisible(), false);
  await load();
  await expect(() => page.locator('#program-panel').isVisible(), true);
  await replaceAll(page, OF(['L 1', 'T MW 10', 'U #nowhere']));
  await load();
  await expect(() => problems(page).count(), 1);
  assert.equal(await bars(), 0);
  await replaceAll(page, OF(['L 1', 'T MW 10']));
  await load();
  await message(page, 'Programm geladen');
  await until(async () => (await problems(page).count()) === 0 && (await bars()) === 0, 'nothing left');
});

test('what is no error of the text is told in a message, until the next load', async () => {
  await turn(page, 'RUN');
  await load();
  await message(page, /RUN-P/);
  await expect(bars, 1);
  await turn(page, 'RUN-P');
  await load();
  await message(page, 'Programm geladen');
  await expect(bars, 0);
});
