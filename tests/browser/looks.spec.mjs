// Each view in both themes, both languages and both sizes: no serious accessibility problem, nothing sticks out.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { open, serve, visit } from './harness.mjs';

const views = ['projects', 'hardware', 'hardware?mode=plan', 'symbols', 'program', 'io', 'variables', 'process', 'trends', 'diagnosis'];
// Every pair of theme, language and size.
const looks = [
  { theme: 'light', language: 'en', width: 1280, height: 800 },
  { theme: 'dark', language: 'de', width: 1280, height: 800 },
  { theme: 'dark', language: 'en', width: 1024, height: 768 },
  { theme: 'light', language: 'de', width: 1024, height: 768 },
];
const server = await serve();

for (const look of looks) {
  const page = await open(server, 'io', look);
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
    });
  }
}
