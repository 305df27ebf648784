// The panel of a SINUMERIK's NC: what is typed there reaches the program, what the program does is seen there (docs/formats/nc.md,
// S5-FM-12, S5-FM-18, S5-FLAG-11).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { crowding } from './layout.mjs';
import { bit, expect, message, open, picture, serve, until, visit } from './harness.mjs';

const server = await serve('step5/machine-values');
const page = await open(server, 'nc', { language: 'en' });
const watching = await open(server, 'io', { language: 'en' });
const sorting = await serve();
const other = await open(sorting, 'io', { language: 'en' });
const cell = (datum) => page.locator(`[data-operand="nc.${datum}"]`);
const shows = (datum) => cell(datum).evaluate((one) => one.value ?? one.textContent);

async function type(datum, value) {
  // What comes while one types would stand before it.
  await until(async () => !['', '?'].includes(await shows(datum)), `a value of ${datum}`);
  await cell(datum).fill(value);
  await cell(datum).press('Enter');
}

test('speed and feed of the panel switch the cooling on', async () => {
  await watching.locator('#tile-operand').fill('AB 1');
  await watching.locator('#tile-operand').press('Enter');
  await expect(() => bit(watching, 'A 1.0'), '0');
  await type('spindle_speed 1', '1500');
  await type('path_feed 1', '1425.67');
  await expect(() => bit(watching, 'A 1.0'), '1');
  await type('spindle_speed 1', '0');
  await expect(() => bit(watching, 'A 1.0'), '0');
});

test('an axis moves: the workpiece position follows, a comma is a point', async () => {
  await type('position 3', '20,5');
  await expect(() => shows('workpiece_position 3'), '-29.500');
  await expect(() => bit(watching, 'A 1.1'), '1');
  assert.equal(await cell('workpiece_position 3').evaluate((one) => one.localName), 'output', 'a sum is only read');
});

test('what the NC does not take is refused and stays as it was', async () => {
  await type('spindle_speed 1', 'fast');
  await message(page, 'must be written with digits and a point');
  await cell('spindle_speed 1').press('Escape');
  assert.equal(await shows('spindle_speed 1'), '0');
});

test('alarms: raised, seen in M 24.0, cleared', async () => {
  await page.getByLabel('Alarm no.', { exact: true }).fill('3016');
  await page.getByLabel('Alarm no.', { exact: true }).press('Enter');
  await page.getByRole('button', { name: 'Clear alarm 3016' }).waitFor();
  await watching.locator('#tile-operand').fill('MB 24');
  await watching.locator('#tile-operand').press('Enter');
  await expect(() => bit(watching, 'M 24.0'), '1');
  await page.getByRole('button', { name: 'Clear alarm 3016' }).click();
  await page.getByText('No alarm is pending.').waitFor();
  await expect(() => bit(watching, 'M 24.0'), '0');
});

test('signals: a probe', async () => {
  await page.getByRole('switch', { name: 'Probe 1' }).click();
  await expect(() => bit(watching, 'M 24.6'), '1');
});

test('tools, offsets, R parameters and machine data by tabs, with the keyboard', async () => {
  await page.getByRole('tab', { name: 'R parameters' }).focus();
  await page.keyboard.press('ArrowRight');
  await page.getByLabel('Tool D', { exact: true }).fill('7');
  await page.getByLabel('Tool D', { exact: true }).press('Enter');
  await expect(() => shows('tool 7.2'), '123.456');
  await page.getByRole('tab', { name: 'Tools' }).press('ArrowRight');
  await expect(() => shows('settable_offset 1.3'), '50.000');
  await page.getByRole('tab', { name: 'Zero offsets' }).press('ArrowRight');
  await page.getByLabel('from', { exact: true }).fill('155');
  await page.getByLabel('from', { exact: true }).press('Enter');
  await until(async () => (await shows('MD 155')) !== '', 'MD 155');
  await page.getByRole('tab', { name: 'Machine data' }).press('ArrowRight');
  await page.getByLabel('from', { exact: true }).fill('50');
  await page.getByLabel('from', { exact: true }).press('Enter');
  await type('R 1.50', '-0.5');
  await expect(() => shows('R 1.50'), '-0.5');
});

test('every datum of every page has a value', async () => {
  const unknown = () => page.evaluate(() => [...document.querySelectorAll('main [data-operand]')].filter((one) => ['', '?'].includes(one.value ?? one.textContent)).map((one) => one.dataset.operand));
  let left = [];
  const whole = () => until(async () => (left = await unknown()).length === 0, () => `values of ${left}`);
  await page.getByRole('tab', { name: 'Tools' }).click();
  await page.getByLabel('Tool D', { exact: true }).fill('99');
  await page.getByLabel('Tool D', { exact: true }).press('Enter');
  await page.locator('[data-operand="nc.tool 99.15"]').waitFor();
  await whole();
  await page.getByRole('tab', { name: 'Zero offsets' }).click();
  for (const group of ['1', '2', '3', '4']) {
    await page.locator('select[aria-label="Settable offset"]').selectOption(group);
    await page.locator(`[data-operand="nc.settable_offset ${group}.5.1"]`).waitFor();
    await whole();
  }
  for (const [tab, ranges] of [['R parameters', [['channel1', 'R 1.499'], ['channel2', 'R 2.499'], ['central', 'R 999']]],
    ['Machine data', [['machine', 'MD 4999'], ['machineBits', 'MD 9999'], ['setting', 'SD 4999'], ['settingBits', 'SD 9999']]]]) {
    await page.getByRole('tab', { name: tab }).click();
    for (const [range, last] of ranges) {
      await page.getByLabel('Range').selectOption(range);
      await page.getByLabel('from', { exact: true }).fill('99999');
      await page.getByLabel('from', { exact: true }).press('Enter');
      await page.locator(`[data-operand="nc.${last}"]`).waitFor();
      await whole();
    }
  }
});

test('every signal is switched on and off', async () => {
  const switches = page.getByRole('switch');
  const names = (await switches.allInnerTexts()).map((one) => one.trim());
  assert.equal(names.length, 7);
  for (const name of names) {
    const one = page.getByRole('switch', { name });
    const before = await one.getAttribute('aria-checked');
    const other = before === 'true' ? 'false' : 'true';
    await one.click();
    await expect(() => one.getAttribute('aria-checked'), other, name);
    await one.click();
    await expect(() => one.getAttribute('aria-checked'), before, name);
  }
});

for (const [width, height, theme] of [[1280, 800, 'light'], [1024, 768, 'dark'], [768, 1024, 'light']])
  test(`everything has room at ${width} x ${height}`, async () => {
    await page.setViewportSize({ width, height });
    await page.evaluate((one) => (document.documentElement.dataset.theme = one), theme);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${wide} of ${width} px wide`);
    await accessible(page, `nc at ${width} x ${height}`);
    if (width === 1280) await picture(page, 'nc');
  });

test('the German words have room as well', async () => {
  const german = await open(server, 'nc');
  await german.getByText('Bearbeitungsstillstand').waitFor();
  for (const [width, height] of [[1280, 800], [1024, 768], [768, 1024]]) {
    await german.setViewportSize({ width, height });
    let found;
    await until(async () => (found = await crowding(german)).length === 0, () => found.join('\n'));
  }
  await german.context().close();
});

test('a CPU without an NC has no such view', async () => {
  assert.equal(await page.locator('nav a[href="#/nc"]').count(), 1);
  assert.equal(await other.locator('nav a[href="#/nc"]').count(), 0);
  await visit(other, sorting, 'nc');
  await other.getByText('This PLC has no NC.').waitFor();
});
