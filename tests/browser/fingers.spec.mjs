// Rows for use with a finger: what is pressed has the 40 px of docs/workbench.md, in all views, and still finds its room.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { open, serve, until, visit } from './harness.mjs';
import { crowding, low } from './layout.mjs';

const PROJECTS = {
  'sorting-plant': ['projects', 'hardware', 'hardware?mode=plan', 'symbols', 'program?file=sorting.awl', 'io', 'variables', 'process', 'trends', 'diagnosis', 'pictures', 'compare'],
  'networks/production-line': ['stations'],
  'technology/barcode-scanner': ['process', 'serial'],
  'step5/machine-values': ['nc'],
};
/** As large as it is: it scrolls. */
const WIDE = ['hardware'];

for (const [project, views] of Object.entries(PROJECTS))
  test(`${project}: room for a finger on a tablet held upright`, async () => {
    const server = await serve(project);
    const page = await open(server, views[0], { width: 768, height: 1024 });
    await page.evaluate(() => localStorage.setItem('merker.comfortable', 'true'));
    await page.reload();
    for (const view of views) {
      await visit(page, server, view);
      await page.locator(`nav a[href="#/${view.split('?')[0]}"][aria-current]`).waitFor();
      await page.locator('main h1').first().waitFor();
      let found;
      await until(async () => (found = [...(await low(page)), ...(WIDE.includes(view) ? [] : await crowding(page))]).length === 0, () => `${view}:\n${found.join('\n')}`);
      await accessible(page, `${view} for fingers`);
    }
  });


test('a tablet held across: the buttons of the files stand in one row', async () => {
  const page = await open(await serve(), 'program?file=sorting.awl', { width: 1024, height: 768 });
  await page.evaluate(() => localStorage.setItem('merker.comfortable', 'true'));
  await page.reload();
  await page.getByRole('button', { name: 'Datei löschen' }).waitFor();
  const tops = () => page.locator('.files-head button').evaluateAll((all) => all.map((one) => Math.round(one.getBoundingClientRect().top)));
  await until(async () => (await tops()).length === 4, 'four buttons');
  await until(async () => new Set(await tops()).size === 1, 'one row');
  const found = await crowding(page);
  assert.deepEqual(found, []);
});

test('find and replace in the text and the way to a line have room for a finger', async () => {
  const page = await open(await serve(), 'program?file=sorting.awl', { width: 1024, height: 768 });
  await page.evaluate(() => localStorage.setItem('merker.comfortable', 'true'));
  await page.reload();
  for (const key of ['Control+f', 'Control+g']) {
    await page.locator('.code .cm-content').focus();
    await page.keyboard.press(key);
    await page.locator('.code .cm-panel input').first().waitFor();
    const small = () =>
      page.locator('.code .cm-panels').evaluate((panels) =>
        [...panels.querySelectorAll('button, input')].flatMap((one) => {
          const { width, height } = (one.closest('label:has([type=checkbox])') ?? one).getBoundingClientRect();
          return Math.min(width, height) < 40 ? [`${one.name || one.textContent}: ${width} x ${height}`] : [];
        }),
      );
    await until(async () => (await small()).length === 0, () => key);
    assert.deepEqual(await small(), []);
    // The cross covers nothing else.
    const covered = await page.locator('.code .cm-panels').evaluate((panels) => {
      const close = panels.querySelector('[name=close]')?.getBoundingClientRect();
      return close && [...panels.querySelectorAll('input, button:not([name=close])')].some((one) => one.getBoundingClientRect().right > close.left && one.getBoundingClientRect().top < close.bottom);
    });
    assert.ok(!covered, `the cross lies on another control: ${key}`);
    await page.keyboard.press('Escape');
  }
});

test('the front plate unfolded, search and references as well', async () => {
  const page = await open(await serve(), 'program?file=sorting.awl', { width: 768, height: 1024 });
  await page.evaluate(() => localStorage.setItem('merker.comfortable', 'true'));
  await page.reload();
  await page.getByRole('button', { name: 'Frontplatte der CPU' }).click();
  await page.getByRole('radio', { name: 'STOP' }).waitFor();
  for (const tab of ['Suchen', 'Referenzdaten']) {
    await page.getByRole('tab', { name: tab }).click();
    await page.locator('#program-panel').getByRole('searchbox').first().waitFor();
    let found;
    await until(async () => (found = [...(await low(page)), ...(await crowding(page))]).length === 0, () => `${tab}:\n${found.join('\n')}`);
  }
});
