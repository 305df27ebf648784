// An axis: its picture, its faults, its curves, its commissioning (POS-EX-05, POS-PLANT-17, -20, -21). The first project drives it without the
// positioning channel.
import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, history, launch, open, picture, root, scratch, serve, turn, until, visit, write } from './harness.mjs';

const folder = scratch();
const project = join(folder, 'axis');
cpSync(join(root, 'tests/scenario/technology/axis'), project, { recursive: true });
const server = await launch(project, folder);
const page = await open(server, 'process', { language: 'en', width: 1280, height: 720 });

const tag = (name) => page.locator(`button[data-signal="${name}"]`);
const shows = (name) => tag(name).getAttribute('data-value');
const says = (name) => page.locator(`[data-axis="${name}"]`).textContent();
const pulses = async () => Number((await says('pulses')).replace(/[^-\d]/g, ''));
const speed = async () => Number((await says('speed')).replace(/[^-\d]/g, ''));
const toggle = (name) => page.getByRole('switch', { name });
const points = (name) => page.locator(`[data-profile="${name}"]`).getAttribute('data-points');

test('the axis moves: pulses, mm and speed', async () => {
  await turn(page, 'RUN-P');
  const tracks = await history(tag('A'), 'data-value');
  // 13824 are 5 V: half of 10 000 pulses/s.
  await write(page, { 'MW 20': 13824, 'M 0.0': 1 });
  await expect(speed, 5000);
  await expect(() => shows('ENABLE'), '1');
  assert.equal(await shows('SETPOINT'), '5 V');
  await until(async () => (await pulses()) > 20_000, '20 000 pulses');
  await until(async () => (await tracks()).includes('1'), 'track A');
  // 2000 pulses are a turn of the encoder, which is 10 mm.
  await expect(() => page.locator('#axis-pitch').inputValue(), '10');
  await write(page, { 'M 0.0': 0 });
  await expect(speed, 0);
  const at = await pulses();
  assert.equal(await says('way'), `${new Intl.NumberFormat('en-GB', { minimumFractionDigits: 1, maximumFractionDigits: 1 }).format(at / 200)} mm`);
  await page.locator('#axis-pitch').fill('5');
  await page.locator('#axis-pitch').press('Enter');
  await expect(() => says('way'), `${new Intl.NumberFormat('en-GB', { minimumFractionDigits: 1, maximumFractionDigits: 1 }).format(at / 400)} mm`);
});

test('position and speed over time, speed over distance', async () => {
  await until(async () => Number(await points('position')) > 10, 'points of the position');
  await until(async () => Number(await points('speed')) > 4, 'points of the speed');
  await page.getByRole('tab', { name: 'Over distance' }).click();
  await until(async () => Number(await points('way')) > 4, 'points over the distance');
  await page.getByRole('tab', { name: 'Over time' }).click();
  await page.getByRole('button', { name: 'Pause' }).last().click();
  const held = await points('position');
  await write(page, { 'M 0.0': 1 });
  await expect(speed, 5000);
  assert.equal(await points('position'), held, 'a paused chart');
  await page.getByRole('button', { name: 'Pause' }).last().click();
  await until(async () => (await points('position')) !== held, 'the chart goes on');
  await accessible(page, 'axis');
});

test('a blocked axis stands, without enable it coasts', async () => {
  await toggle('Axis blocked').click();
  await expect(speed, 0);
  await toggle('Axis blocked').click();
  await expect(speed, 5000);
  await toggle('Enable missing').click();
  await expect(speed, 0);
  assert.equal(await shows('ENABLE'), '0');
  await toggle('Enable missing').click();
  await expect(speed, 5000);
  await toggle('Emergency stop').click();
  await expect(speed, 0);
  await toggle('Emergency stop').click();
});

test('a broken wire of track A: the axis moves, the count stands', async () => {
  await expect(speed, 5000);
  await toggle('Wire break of track A').click();
  await expect(() => tag('A').evaluate((one) => one.classList.contains('stuck')), true);
  const levels = await history(tag('A'), 'data-value');
  const from = await pulses();
  await until(async () => (await pulses()) > from + 2000, 'the axis moves on');
  assert.deepEqual([...new Set(await levels())], ['0']);
  await toggle('Wire break of track A').click();
  await expect(() => tag('A').evaluate((one) => one.classList.contains('stuck')), false);
  // At a constant speed every look may fall on the same half of a pulse: the axis stops and starts again.
  await toggle('Emergency stop').click();
  await expect(speed, 0);
  await toggle('Emergency stop').click();
  await until(async () => (await levels()).includes('1'), 'track A is back');
  await expect(speed, 5000);
});

test('its curves go into the trends', async () => {
  await page.getByRole('button', { name: 'Record in “Trends”' }).click();
  await page.getByText('plant.Axis.POSITION').first().waitFor();
  await page.getByText('plant.Axis.SETPOINT').first().waitFor();
  await visit(page, server, 'process');
});

const first = await serve('technology/axis-first-steps');
const german = await open(first, 'process?mode=commissioning', { width: 1280, height: 720, stays: true });
const step = (name, on = german) => on.locator(`[data-step="${name}"]`);
const state = (name, on = german) => step(name, on).getAttribute('data-state');
const seen = (name, what, on = german) => step(name, on).locator(`[data-seen="${what}"]`).innerText();
const push = (name, on = german) => on.locator(`button[data-push="${name}"]`);
const field = (name, on = german) => on.getByLabel(name, { exact: true });
async function enter(name, value, on = german) {
  await field(name, on).fill(String(value));
  await field(name, on).press('Enter');
  await expect(() => field(name, on).inputValue(), String(value), name);
}
/** Holds a button until something is so. */
async function hold(name, until, on = german) {
  await push(name, on).hover();
  await on.mouse.down();
  await until();
  await on.mouse.up();
}
const plantView = async (does) => {
  await german.getByRole('tab', { name: 'Anlage' }).click();
  await does();
  await german.getByRole('tab', { name: 'Inbetriebnahme' }).click();
};
const setSwitch = (name) => german.getByRole('switch', { name }).click();

test('commissioning: requirements and wiring', async () => {
  await turn(german, 'RUN-P');
  await expect(() => state('prepare'), 'good');
  assert.equal(await seen('prepare', 'SFB 44 wird aufgerufen'), 'DB 20');
  await expect(() => state('wiring'), 'good');
  assert.equal(await seen('wiring', 'Spur A'), 'E 124.0');
  await expect(() => state('movement'), 'open');
  await plantView(() => setSwitch('Drahtbruch Spur B'));
  await expect(() => state('wiring'), 'bad');
  assert.match(await seen('wiring', 'Spur B'), /klemmt bei 0/);
  await plantView(() => setSwitch('Drahtbruch Spur B'));
  await expect(() => state('wiring'), 'good');
});

test('commissioning: jogging in both directions', async () => {
  await hold('DIR_P', () => expect(() => seen('movement', 'Richtung Plus'), 'richtig'));
  await expect(() => state('movement'), 'good');
  await hold('DIR_M', () => expect(() => seen('movement', 'Richtung Minus'), 'richtig'));
  await expect(() => seen('movement', 'DIR'), '1');
});

test('commissioning: swapped tracks are found, with the parameter that mends them', async () => {
  await plantView(() => setSwitch(/Spuren.* vertauscht/));
  await hold('DIR_P', () => expect(() => seen('movement', 'Richtung Plus'), 'ACT_POS läuft verkehrt herum'));
  await expect(() => state('movement'), 'bad');
  await step('movement').getByText('„Zählrichtung“').waitFor();
  await plantView(() => setSwitch(/Spuren.* vertauscht/));
});

test('commissioning: the reference point is set', async () => {
  await german.getByRole('button', { name: 'Quittieren ERR_A' }).click();
  await expect(() => seen('synchronise', 'SYNC'), '0');
  await enter('JOB_VAL', 400_000);
  await german.getByRole('button', { name: 'Bezugspunkt setzen' }).click();
  await german.getByText(/JOB_STAT 4101H.*außerhalb des Arbeitsbereichs/).waitFor();
  await expect(() => state('synchronise'), 'bad');
  await enter('JOB_VAL', 1000);
  await german.getByRole('button', { name: 'Bezugspunkt setzen' }).click();
  await expect(() => state('synchronise'), 'good');
  assert.equal(await seen('synchronise', 'ACT_POS'), '1.000');
});

async function travel(target) {
  await enter('TARGET', target);
  await german.getByRole('button', { name: 'Relativ +' }).click();
}

test('commissioning: the differences', async () => {
  await enter('SPEED', 10_000);
  await enter('CHGDIFF_P', 120);
  await travel(20_000);
  await expect(() => seen('differences', 'Letzte Fahrt'), 'Zielbereich erreicht');
  await enter('CHGDIFF_P', 2000);
  await enter('CUTOFFDIFF_P', 400);
  await travel(20_000);
  await expect(() => seen('differences', 'Letzte Fahrt'), 'vor dem Zielbereich stehen geblieben');
  await step('differences').getByText(/CUTOFFDIFF_P verkleinern/).waitFor();
  await expect(() => state('differences'), 'bad');
});

test('its picture has the target and the switching points', async () => {
  await german.getByRole('tab', { name: 'Anlage' }).click();
  await german.locator('path[data-axis="target"]').first().waitFor();
  await german.getByRole('tab', { name: 'Über dem Weg' }).click();
  for (const mark of ['Ziel', 'Umschaltpunkt', 'Abschaltpunkt']) await german.locator(`[data-mark="${mark}"]`).waitFor({ state: 'attached' });
  await picture(german, 'process-axis');
  await accessible(german, 'axis of a CPU');
  await german.getByRole('tab', { name: 'Inbetriebnahme' }).click();
  await picture(german, 'commissioning');
  await accessible(german, 'commissioning');
});

test('its parameters are the pages of the manual', async () => {
  await visit(german, first, 'hardware?mode=plan');
  await german.getByRole('table', { name: 'Baugruppenträger 0' }).locator('tr[data-slot="2.5"]').getByRole('button').click();
  const pages = german.getByRole('tablist', { name: 'Masken' }).getByRole('tab');
  assert.deepEqual(await pages.allInnerTexts(), ['Allgemein', 'Adressen', 'Grundparameter', 'Antrieb', 'Achse', 'Geber', 'Diagnose']);
  await pages.filter({ hasText: 'Achse' }).click();
  assert.ok(await german.getByRole('switch', { name: 'Überwachung Verfahrbereich' }).isDisabled());
  await german.getByLabel('Achsart').selectOption('rotary');
  // What only the linear axis has goes with it.
  await german.getByLabel('Rundachsenende (Impulse)').waitFor();
  await german.getByText('nicht gespeichert').waitFor();
  await german.getByRole('button', { name: 'Rückgängig' }).click();
  await expect(() => german.getByLabel('Softwareendschalter Ende').inputValue(), '300000');
  await pages.filter({ hasText: 'Geber' }).click();
  await german.getByLabel('Zählrichtung').selectOption('inverted');
  await expect(() => german.getByLabel('Zählrichtung').inputValue(), 'inverted');
});

// SFB 46, contactors, a play between motor and load.
const second = await serve('technology/axis-first-steps-contactors');
const english = await open(second, 'process?mode=commissioning', { language: 'en', width: 1280, height: 720, stays: true });
const press = (name) => english.getByRole('button', { name, exact: true }).click();

test('SFB 46: requirements, contactors, jogging', async () => {
  await turn(english, 'RUN-P');
  await expect(() => state('prepare', english), 'good');
  assert.equal(await seen('prepare', 'SFB 46 is called', english), 'DB 22');
  await expect(() => state('wiring', english), 'good');
  assert.equal(await seen('wiring', 'Contactor Q0', english), 'A 125.0');
  await hold('DIR_P', () => expect(() => seen('movement', 'Plus direction', english), 'right'), english);
  await hold('DIR_M', () => expect(() => seen('movement', 'Minus direction', english), 'right'), english);
  await expect(() => state('movement', english), 'good');
});

test('SFB 46: the reference point, then a run in rapid with the differences', async () => {
  await enter('JOB_VAL', 0, english);
  await press('Set reference point');
  await expect(() => state('synchronise', english), 'good');
  await english.getByRole('switch', { name: 'Rapid (SPEED)' }).click();
  await enter('TARGET', 20_000, english);
  await enter('CHGDIFF_P', 1000, english);
  await press('Relative +');
  await expect(() => seen('differences', 'Last run', english), 'cut off above creep speed');
  await expect(() => state('differences', english), 'bad');
  await press('Acknowledge ERR_A');
  await enter('CHGDIFF_P', 3500, english);
  await press('Relative +');
  await expect(() => seen('differences', 'Last run', english), 'target range reached');
});

test('the picture: contactors, the encoder beside the load, no workpiece without its sensor', async () => {
  await english.getByRole('tab', { name: 'Plant' }).click();
  await until(async () => /^encoder [\d,]+ pulses$/.test(await english.locator('[data-axis="encoder"]').textContent()), 'the encoder');
  await english.locator('button[data-signal="Q3"]').waitFor();
  await english.locator('button[data-signal="WORKPIECE"]').waitFor();
  const gantry = await serve('technology/drilling-gantry');
  const other = await open(gantry, 'process', { language: 'en', width: 1280, height: 720 });
  await other.locator('button[data-signal="REFERENCE"]').waitFor();
  assert.equal(await other.locator('button[data-signal="WORKPIECE"]').count(), 0);
  const box = await other.locator('button[data-signal="Q3"]').boundingBox();
  const numbers = await other.locator('svg text.soft').first().boundingBox();
  assert.ok(numbers.y >= box.y + box.height, 'the contactors leave the scale free');
});

test('jogging ends when the connection is lost', async () => {
  const speedNow = async () => Number((await english.locator('[data-axis="speed"]').textContent()).replace(/[^-\d]/g, ''));
  // What the button sends, from a connection that goes while it is down.
  await english.getByRole('tab', { name: 'Commissioning' }).click();
  await english.evaluate(() => {
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (data) {
      if (JSON.parse(data).do === 'variables.write') (globalThis.sent ??= []).push(data);
      send.call(this, data);
    };
  });
  await hold('DIR_M', () => until(() => english.evaluate(() => globalThis.sent?.length > 0), 'the request'), english);
  await english.getByRole('tab', { name: 'Plant' }).click();
  await expect(speedNow, 0);
  await english.evaluate(() => {
    globalThis.other = new WebSocket(new URL('ws', location.href).href.replace(/^http/, 'ws').replace(/#.*/, ''));
    globalThis.other.onopen = () => globalThis.other.send(globalThis.sent[0]);
  });
  await until(async () => (await speedNow()) < 0, 'the axis moves');
  await english.evaluate(() => globalThis.other.close());
  await expect(speedNow, 0);
});
