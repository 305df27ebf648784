// The plant's picture: boxes are sorted, a stuck sensor makes the difference, reset; every kind moves (S7-VIS-01, S7-VIS-04, S7-VIS-07).
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, history, leave, open, picture, serve, turn, until } from './harness.mjs';

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

/** What a signal shows is recorded from now on: the result waits until it has had a value, however short. */
async function had(signal, on) {
  const values = await history(tag(signal, on), 'data-value');
  return (value) => until(async () => (await values()).includes(value), `${signal} ${value}`);
}

test('a box of each size goes into its bin', async () => {
  await turn(page, 'RUN-P');
  // A click asks for the other of what is shown: what was asked before must be seen first.
  const comes = (shown) => expect(() => toggle('Kästen kommen von selbst').getAttribute('aria-checked'), shown);
  await toggle('Kästen kommen von selbst').click();
  await comes('false');
  await page.getByRole('button', { name: 'Zurück zum Anfang' }).click();
  await comes('true');
  await toggle('Kästen kommen von selbst').click();
  await comes('false');
  const beam = await history(tag('BARRIER_SMALL'), 'data-value');
  // One after the other: however slowly they are pressed, none is behind a slider that is out.
  for (const [index, box] of ['NEW_LARGE', 'NEW_MIDDLE', 'NEW_SMALL'].entries()) {
    await press(box);
    await expect(() => count('GOOD'), String(index + 1));
  }
  assert.ok((await beam()).includes('0'), 'a box in the beam');
  assert.equal(await count('WRONG'), '0');
});

test('the plates have names and operands, and room for a finger, on a tablet as well', async () => {
  assert.match(await tag('BARRIER_LARGE').innerText(), /^Lichtschranke groß\s+E 0\.2\s+[01]$/);
  const smallest = () => page.locator('[data-signal], [data-push], .view-head button').evaluateAll((all) => Math.min(...all.map((one) => one.getBoundingClientRect().height)));
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await until(async () => (await smallest()) >= 40, `40 px at ${width}`);
    await accessible(page, `plates at ${width}`);
  }
});

test('a stuck light barrier takes a large box for a middle one', async () => {
  await tag('BARRIER_LARGE').click();
  await page.getByRole('button', { name: 'Klemmt bei 1' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Schließen' }).last().click();
  await expect(() => tag('BARRIER_LARGE').evaluate((one) => one.classList.contains('stuck')), true);
  await press('NEW_LARGE');
  await expect(() => count('WRONG'), '1');
  await expect(() => shows('BARRIER_LARGE'), '1');
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
  await leave(page);
});

const plants = {
  'vessel-emptying': async (page) => {
    const outlet = await had('OUTLET', page);
    await press('START', page);
    await outlet('1');
    await passes('LEVEL', (level) => level < 90, page);
    await picture(page, 'process-vessel');
    await press('STOP', page);
    await expect(() => shows('OUTLET', page), '0');
  },
  'garage-door': async (page) => {
    const up = await had('UP', page);
    await press('BUTTON', page);
    await up('1');
    await passes('POSITION', (position) => position > 40, page);
    await picture(page, 'process-garage-door');
    await press('BUTTON', page);
    await expect(() => shows('UP', page), '0');
  },
  lift: async (page) => {
    const [lamp, door] = [await had('LAMP2', page), await had('DOOR_OPEN', page)];
    await press('CALL2', page);
    await lamp('1');
    await passes('HEIGHT', (height) => height > 0.5, page);
    await picture(page, 'process-lift');
    await door('1');
    assert.equal(await count('FAULTS', page), '0');
  },
  'traffic-light': async (page) => {
    await expect(() => shows('CARS_GREEN', page), '1');
    const [wait, amber] = [await had('WAIT', page), await had('CARS_AMBER', page)];
    await press('LEFT', page);
    await wait('1');
    await picture(page, 'process-traffic-light');
    await amber('1');
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
    const own = await serve(example);
    const page = await open(own, 'process', { language: 'en' });
    await turn(page, 'RUN-P');
    await look(page);
    await accessible(page, example);
    // What moves here takes the processor from the next.
    await page.context().close();
    await own.close();
  });
}

test('without a project the view says what to do, and no supply is shown as on', async () => {
  const empty = await serve();
  const page = await open(empty, 'process');
  await page.locator('[data-signal]').first().waitFor();
  await page.evaluate(
    () =>
      new Promise((done) => {
        const socket = new WebSocket(new URL('ws', location.href).href.replace(/^http/, 'ws').replace(/#.*/, ''));
        socket.onopen = () => socket.send(JSON.stringify({ id: 1, do: 'projects.close' }));
        socket.onmessage = ({ data }) => JSON.parse(data).id === 1 && (socket.close(), done(0));
      }),
  );
  await page.getByText('Es ist kein Projekt offen').waitFor();
  await expect(() => page.getByRole('button', { name: 'Netz', includeHidden: true }).getAttribute('aria-pressed'), 'false');
});

// POS-PLANT-21: an axis without hardware: hand wheel, faults, what lies along it
test('an axis is turned by hand; its faults are switches', async () => {
  const own = await serve('technology/axis-first-steps');
  const axis = await open(own, 'process');
  await turn(axis, 'RUN-P');
  for (const name of ['SETPOINT', 'ENABLE', 'A', 'B', 'N', 'REFERENCE', 'WORKPIECE', 'LOW_SWITCH', 'HIGH_SWITCH'])
    await tag(name, axis).waitFor();
  for (const name of ['Achse blockiert', 'Not-Halt', 'Spuren vertauscht'])
    await axis.getByRole('switch', { name }).waitFor();
  const wheel = axis.getByRole('slider', { name: /Handrad/ });
  await wheel.fill('1000');
  await wheel.dispatchEvent('change');
  await passes('POSITION', (value) => value > 300, axis);
  await wheel.fill('-1000');
  await wheel.dispatchEvent('change');
  await passes('POSITION', (value) => value < 0, axis);
  await leave(axis);
});
