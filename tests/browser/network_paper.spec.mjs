// Networks of KOP and FUP on paper, with and without comments, with breakpoints; STEP 5 with its status (S7-EDIT-13, -15, -21).
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { expect, launch, message, open, scratch, turn, until, write } from './harness.mjs';
import { networksOf, OF, project } from './networks.mjs';

const plc = await project('314C-2 PtP', 'main.awl', OF(['U E 0.0;', '= A 1.0;']));
const page = await open(plc, 'program?file=main.awl', { height: 720 });
const { press, network, drawn } = networksOf(page);

test('comments are shown or not; on paper is the drawing alone, without a mark', async () => {
  await drawn('kop', OF(['U E 0.0;', '= A 1.0;']).replace('NETWORK\n', 'NETWORK\nTITLE = Lamp\n//Of the door\n'));
  await network().getByText('Of the door').waitFor();
  await page.getByRole('switch', { name: 'Kommentare' }).click();
  await expect(() => network().getByText('Of the door').count(), 0);
  await page.getByRole('switch', { name: 'Kommentare' }).click();
  await page.emulateMedia({ media: 'print' });
  for (const hidden of ['.palette', '.item', '.panel', '.point'])
    assert.equal(await page.locator(hidden).first().isVisible(), false, hidden);
  assert.ok(await network().locator('.symbol').first().isVisible());
  assert.ok((await page.pdf()).length > 1000);
  await page.emulateMedia({ media: null });
});

test('a ladder wider than the paper goes on below, at one size, and its coil is there', async () => {
  const numbers = Array.from({ length: 12 }, (_, index) => String(index).padStart(2, '0'));
  const workspace = scratch();
  const folder = join(workspace, 'wide');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[cpu]\nmodel = "314C-2 PtP"\n');
  writeFileSync(join(folder, 'main.sym'), numbers.map((one) => `"Endlagenschalter Nr ${one}"  M 1${one}.0  BOOL\n`).join(''));
  writeFileSync(join(folder, 'main.awl'), OF([...numbers.map((one) => `U "Endlagenschalter Nr ${one}";`), '= A 1.0;']));
  const wide = await launch(folder, workspace);
  const paper = await open(wide, 'program?file=main.awl', { width: 1280, height: 720 });
  await paper.getByRole('button', { name: 'KOP', exact: true }).click();
  await paper.locator('[data-network="1"] .symbol').first().waitFor();
  await paper.setViewportSize({ width: 718, height: 1000 });
  await paper.emulateMedia({ media: 'print' });
  const strips = paper.locator('[data-network="1"] .strips svg');
  await until(async () => (await strips.count()) > 1, 'strips');
  const seen = await strips.evaluateAll((all) => all.map((one) => {
    const { left, right, width, height } = one.getBoundingClientRect();
    return { left, right, scale: width / one.viewBox.baseVal.width, from: one.viewBox.baseVal.x, to: one.viewBox.baseVal.x + one.viewBox.baseVal.width, drawn: height > 0 && one.querySelector('use').getBoundingClientRect().width > 0 };
  }));
  const whole = await paper.locator('[data-network="1"] .divided').evaluate((one) => one.viewBox.baseVal.width);
  assert.equal(seen[0].from, 0);
  assert.equal(seen.at(-1).to, whole);
  seen.forEach((one, index) => {
    if (index > 0) assert.equal(one.from, seen[index - 1].to);
    assert.ok(one.left >= 0 && one.right <= 718 && one.drawn, JSON.stringify(one));
    assert.ok(one.scale > 0.6 && Math.abs(one.scale - seen[0].scale) < 0.01, JSON.stringify(one));
  });
  assert.equal(await paper.evaluate(() => document.documentElement.scrollWidth), 718);
  await paper.emulateMedia({ media: null });
  await expect(() => strips.count(), 0);
});

test('the dot before a network stops at its first statement', async () => {
  await press('Control+s');
  await message(page, 'main.awl gespeichert');
  await page.getByRole('button', { name: 'Laden', exact: true }).click();
  await message(page, 'Programm geladen');
  const dot = page.getByRole('button', { name: 'Haltepunkt an Netzwerk 1' });
  await dot.click();
  await page.getByRole('button', { name: /^Fortsetzen/ }).waitFor();
  await network().locator('.item.halt').first().waitFor();
  await dot.click();
  await expect(() => dot.getAttribute('aria-pressed'), 'false');
  await page.getByRole('button', { name: /^Fortsetzen/ }).click();
  await expect(() => network().locator('.item.halt').count(), 0);
});

test('STEP 5: the ladder of a listing has its status', async () => {
  const control = await project('SINUMERIK 810 GA3', 'main.s5', 'OB 1\nNETZWERK 1  lamp\n :U E 0.0\n := M 1.0\n :BE\n');
  const listing = await open(control, 'program?file=main.s5', { height: 720 });
  await listing.getByRole('button', { name: 'KOP', exact: true }).click();
  const all = () => listing.locator('[data-network="1"] .symbol').evaluateAll((some) => some.map((one) => ['on', 'off'].find((state) => one.classList.contains(state)) ?? '-').join(' '));
  await listing.getByRole('switch', { name: 'Status' }).click();
  await turn(listing, 'RUN');
  for (const [value, seen] of [[1, 'on on'], [0, 'off off']]) {
    await write(listing, { 'E 0.0': value });
    await expect(all, seen);
  }
});
