// Each view in both themes, both languages and both sizes: no serious accessibility problem, nothing sticks out or lies on something else, in no view and
// in no plant's picture, also on a tablet held upright.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { launch, open, scratch, serve, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const views = ['projects', 'hardware', 'hardware?mode=plan', 'symbols', 'program', 'io', 'variables', 'process', 'trends', 'diagnosis'];
// Every pair of theme, language and size.
const looks = [
  { theme: 'light', language: 'en', width: 1280, height: 800 },
  { theme: 'dark', language: 'de', width: 1280, height: 800 },
  { theme: 'dark', language: 'en', width: 1024, height: 768 },
  { theme: 'light', language: 'de', width: 1024, height: 768 },
];
const server = await serve();
// All before the first test: the runner ends when it knows of no more.
const pages = [];
for (const look of looks) pages.push(await open(server, 'io', look));

for (const [index, look] of looks.entries()) {
  const page = pages[index];
  for (const view of views) {
    test(`${view}, ${look.theme}, ${look.language}, ${look.width} x ${look.height}`, async () => {
      await visit(page, server, view);
      await page.locator('main h1').waitFor();
      await page.locator(`nav a[href="#/${view.split('?')[0]}"][aria-current]`).waitFor();
      await accessible(page, view);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      const navigation = page.locator('header nav');
      assert.ok(await navigation.evaluate((nav) => nav.scrollWidth <= nav.clientWidth), 'a view is out of sight');
      assert.ok(wide <= look.width, `${wide} px wide`);
      // Views scroll in themselves; the page never does.
      const high = await page.evaluate(() => document.documentElement.scrollHeight);
      assert.ok(high <= look.height, `${high} px high`);
    });
  }
}

const sizes = [[1280, 800], [1180, 820], [820, 1180]];
const plants = ['vessel-emptying', 'garage-door', 'lift', 'traffic-light', 'technology/temperature-control', 'technology/axis-first-steps'];

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
        for (const [width, height] of sizes) {
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
      for (const [width, height] of sizes) {
        await page.setViewportSize({ width, height });
        await roomy(page);
      }
    }
    await page.context().close();
  }
});
