// Each view in both themes and three sizes: no accessibility problem, nothing sticks out or lies on something else, in no view and
// in no plant's picture, also on a tablet held upright.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible, faultless } from './axe.mjs';
import { launch, open, scratch, serve, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const views = ['projects', 'hardware', 'hardware?mode=plan', 'symbols', 'program', 'io', 'variables', 'process', 'trends', 'diagnosis'];
const server = await serve();
const several = await serve('networks/token-ring');
// All before the first test: the runner ends when it knows of no more.
const pages = { de: await open(server, 'io'), en: await open(server, 'io', { language: 'en' }) };
const networked = await open(several, 'stations');

/** The page itself never scrolls, its views do; each view can be reached. */
async function fits(page, width, height) {
  await page.setViewportSize({ width, height });
  const [wide, high] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  assert.ok(wide <= width, `${wide} of ${width} px wide`);
  assert.ok(high <= height, `${high} of ${height} px high`);
  const navigation = page.locator('header nav');
  assert.ok(await navigation.evaluate((nav) => nav.scrollWidth <= nav.clientWidth), `a view is out of sight at ${width} px`);
}

/** In this size: all rules, and again those of colours in the other theme. */
async function goodLooking(page, view) {
  await page.evaluate(() => (document.documentElement.dataset.theme = 'light'));
  await faultless(page, `${view}, light`);
  await page.evaluate(() => (document.documentElement.dataset.theme = 'dark'));
  await accessible(page, `${view}, dark`, ['color-contrast']);
}

async function arrive(page, of, view) {
  await visit(page, of, view);
  await page.locator('main h1').waitFor();
  await page.locator(`nav a[href="#/${view.split('?')[0]}"][aria-current]`).waitFor();
}

for (const [view, of, page] of [...views, 'compare', 'pictures'].map((one) => [one, server, pages.de]).concat([['stations', several, networked]]))
  test(`${view}: both themes, three sizes`, async () => {
    await arrive(page, of, view);
    for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) {
      await fits(page, width, height);
      await goodLooking(page, `${view} at ${width} x ${height}`);
    }
  });

for (const view of views)
  test(`${view}: three sizes in English`, async () => {
    await arrive(pages.en, server, view);
    for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) await fits(pages.en, width, height);
  });

const sizes = [[1280, 800], [1180, 820], [820, 1180]];
/** A rack scrolls in its frame on a small tablet, a plant has room. */
const ofPlants = [...sizes, [768, 1024]];
const plants = ['vessel-emptying', 'garage-door', 'lift', 'traffic-light', 'technology/temperature-control', 'technology/axis-first-steps', 'technology/rotary-table'];

/** Nothing is crowded, as soon as the view has what it shows. */
async function roomy(page) {
  let found;
  await until(async () => (found = await crowding(page)).length === 0, () => `room: ${found.join('\n')}`);
}

for (const plant of [null, ...plants])
  for (const language of ['de', 'en'])
    test(`${plant ?? 'sorting-plant'}: room for everything, ${language}`, async () => {
      const of = plant ? await serve(plant) : server;
      const page = await open(of, 'io', { language });
      for (const view of plant ? ['process'] : views) {
        await visit(page, of, view);
        await page.locator(`nav a[href="#/${view.split('?')[0]}"][aria-current]`).waitFor();
        if (view === 'process') await page.locator('[data-signal]').first().waitFor();
        for (const [width, height] of view === 'process' ? ofPlants : sizes) {
          await page.setViewportSize({ width, height });
          await roomy(page);
        }
      }
      await page.context().close();
      if (plant) await of.close();
    });

const kinds = ['sorting plant', 'vessel', 'garage door', 'traffic light', 'lift', 'temperature', 'axis'];

test('plants without wires: room for everything', async () => {
  const folder = scratch();
  const plants = kinds.map((kind) => `[[plant]]\nname = "${kind.replace(' ', '_')}"\nkind = "${kind}"\n`);
  writeFileSync(join(folder, 'merker.toml'), `[project]\nname = "Plants"\n\n[[module]]\nslot = 4\ntype = "6ES7 321-1BH02-0AA0"\n\n${plants.join('')}`);
  writeFileSync(join(folder, 'main.awl'), 'ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      NOP   0;\nEND_ORGANIZATION_BLOCK\n');
  const unwired = await launch(folder, folder);
  for (const language of ['de', 'en']) {
    const page = await open(unwired, 'process', { language });
    for (const kind of kinds) {
      await page.getByRole('tab', { name: kind.replace(' ', '_') }).click();
      await page.locator(`[data-plant="${kind.replace(' ', '_')}"] [data-signal]`).first().waitFor();
      for (const [width, height] of ofPlants) {
        await page.setViewportSize({ width, height });
        await roomy(page);
      }
    }
    await page.context().close();
  }
});
