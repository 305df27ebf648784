// The plant's picture: boxes are sorted, a stuck sensor makes the difference, reset; every kind moves (S7-VIS-01, S7-VIS-04, S7-VIS-07).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, open, picture, serve, turn, until } from './harness.mjs';

const server = await serve();
const page = await open(server, 'process');
const tag = (name, on = page) => on.locator(`button[data-signal="${name}"]`);
const shows = (name, on = page) => tag(name, on).getAttribute('data-value');
const count = (name, on = page) => on.locator(`[data-count="${name}"] dd`).innerText();
const toggle = (name) => page.getByRole('switch', { name });
async function press(name, on = page) {
  const button = on.locator(`button[data-push="${name}"]`);
  await button.hover();
  await on.mouse.down();
  await expect(() => button.evaluate((one) => one.classList.contains('pressed')), true);
  await on.mouse.up();
}
/** Until a number of the plant has been passed: in its own time, so with more patience than a click needs. */
const passes = (signal, holds, on) => until(async () => holds(Number.parseFloat(await number(signal, on))), signal);
async function number(signal, on) {
  const row = on.locator(`tr[data-row="${signal}"] .value`);
  if (!(await row.isVisible())) await on.locator('summary').click();
  return row.innerText();
}

test('a box of each size goes into its bin', async () => {
  await turn(page, 'RUN-P');
  await toggle('Kästen kommen von selbst').click();
  await page.getByRole('button', { name: 'Zurück zum Anfang' }).click();
  await toggle('Kästen kommen von selbst').click();
  await expect(() => toggle('Kästen kommen von selbst').getAttribute('aria-checked'), 'false');
  // The slowest first: a slider that is out would stop a box behind the one that it pushes.
  for (const [index, box] of ['NEW_LARGE', 'NEW_MIDDLE', 'NEW_SMALL'].entries()) {
    await press(box);
    await expect(() => page.locator('[data-box]').count(), index + 1);
    await free();
  }
  await expect(() => shows('BARRIER_SMALL'), '0', 'a box in the beam');
  await picture(page, 'process-light');
  for (const good of ['1', '2', '3']) await expect(() => count('GOOD'), good);
  assert.equal(await count('WRONG'), '0');
});

/** Until there is room at the beginning of the belt again. */
async function free() {
  const left = async () => {
    const places = await page.locator('[data-box]').evaluateAll((all) => all.map((one) => Number(/\((.*?)[ ,]/.exec(one.getAttribute('transform'))[1])));
    return Math.min(...places);
  };
  const start = await left();
  await until(async () => (await left()) > start + 60, 'room on the belt');
}

test('a stuck light barrier takes a large box for a middle one', async () => {
  await tag('BARRIER_LARGE').click();
  await page.getByRole('button', { name: 'Klemmt bei 1' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Schließen' }).last().click();
  await expect(() => tag('BARRIER_LARGE').evaluate((one) => one.classList.contains('stuck')), true);
  await press('NEW_LARGE');
  await expect(() => count('WRONG'), '1');
  assert.equal(await shows('BARRIER_LARGE'), '1');
});

test('another browser sees the fault, and reset clears it for both', async () => {
  const other = await open(server, 'process', { language: 'en', theme: 'dark' });
  await expect(() => tag('BARRIER_LARGE', other).evaluate((one) => one.classList.contains('stuck')), true);
  await other.getByRole('button', { name: 'Back to the start' }).click();
  await expect(() => tag('BARRIER_LARGE').evaluate((one) => one.classList.contains('stuck')), false);
  await expect(() => count('WRONG'), '0');
  await picture(other, 'process-dark');
});

test('with the keyboard alone: a box, a fault', async () => {
  await page.locator('button[data-push="NEW_SMALL"]').focus();
  await page.keyboard.down(' ');
  await expect(() => page.locator('[data-box]').count(), 1);
  await page.keyboard.up(' ');
  await tag('SLIDER_SMALL').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor();
  await page.keyboard.press('Escape');
  assert.equal(await page.getByRole('dialog').count(), 0);
});

const plants = {
  'vessel-emptying': async (page) => {
    await press('START', page);
    await expect(() => shows('OUTLET', page), '1');
    await passes('LEVEL', (level) => level < 90, page);
    await picture(page, 'process-vessel');
    await press('STOP', page);
    await expect(() => shows('OUTLET', page), '0');
  },
  'garage-door': async (page) => {
    await press('BUTTON', page);
    await expect(() => shows('UP', page), '1');
    await passes('POSITION', (position) => position > 40, page);
    await picture(page, 'process-garage-door');
    await press('BUTTON', page);
    await expect(() => shows('UP', page), '0');
  },
  lift: async (page) => {
    await press('CALL2', page);
    await expect(() => shows('LAMP2', page), '1');
    await passes('HEIGHT', (height) => height > 0.5, page);
    await picture(page, 'process-lift');
    await expect(() => shows('DOOR_OPEN', page), '1');
    assert.equal(await count('FAULTS', page), '0');
  },
  'traffic-light': async (page) => {
    await expect(() => shows('CARS_GREEN', page), '1');
    await press('LEFT', page);
    await expect(() => shows('WAIT', page), '1');
    await picture(page, 'process-traffic-light');
    await until(async () => (await shows('CARS_AMBER', page)) === '1', 'amber');
  },
  'technology/temperature-control': async (page) => {
    await passes('PV', (degrees) => degrees > 25, page);
    await picture(page, 'process-temperature');
    await page.locator('input[type="range"]').last().fill('60');
    await expect(() => page.locator('output').last().innerText(), '60 °C');
  },
};
for (const [example, look] of Object.entries(plants)) {
  test(`${example} moves`, async () => {
    const page = await open(await serve(example), 'process', { language: 'en' });
    await turn(page, 'RUN-P');
    await look(page);
    await accessible(page, example);
  });
}
