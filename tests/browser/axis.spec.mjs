// An axis: its picture, its faults, its curves (POS-PLANT-17, -20, -21). The project drives it without the positioning channel.
import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, history, launch, open, picture, root, scratch, turn, until, visit } from './harness.mjs';

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

/** As a program or a variable table does. */
const write = (items) =>
  page.evaluate(
    (items) =>
      new Promise((done, failed) => {
        const socket = new WebSocket(new URL('ws', location.href).href.replace(/^http/, 'ws').replace(/#.*/, ''));
        socket.onopen = () => socket.send(JSON.stringify({ id: 1, do: 'variables.write', items }));
        socket.onmessage = ({ data }) => {
          const answer = JSON.parse(data);
          if (answer.id !== 1) return;
          socket.close();
          answer.problems ? failed(new Error(data)) : done(0);
        };
      }),
    items.map(([operand, value]) => ({ operand, value })),
  );

test('the axis moves: pulses, mm and speed', async () => {
  await turn(page, 'RUN-P');
  const tracks = await history(tag('A'), 'data-value');
  // 13824 are 5 V: half of 10 000 pulses/s.
  await write([['MW 20', '13824'], ['M 0.0', '1']]);
  await expect(speed, 5000);
  await expect(() => shows('ENABLE'), '1');
  assert.equal(await shows('SETPOINT'), '5 V');
  await until(async () => (await pulses()) > 20_000, '20 000 pulses');
  await until(async () => (await tracks()).includes('1'), 'track A');
  // 2000 pulses are a turn of the encoder, which is 10 mm.
  await expect(() => page.locator('#axis-pitch').inputValue(), '10');
  await write([['M 0.0', '0']]);
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
  await write([['M 0.0', '1']]);
  await expect(speed, 5000);
  assert.equal(await points('position'), held, 'a paused chart');
  await page.getByRole('button', { name: 'Pause' }).last().click();
  await until(async () => (await points('position')) !== held, 'the chart goes on');
  await picture(page, 'process-axis');
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
  await until(async () => (await levels()).includes('1'), 'track A is back');
});

test('its curves go into the trends', async () => {
  await page.getByRole('button', { name: 'Record in “Trends”' }).click();
  await page.getByText('plant.Axis.POSITION').first().waitFor();
  await page.getByText('plant.Axis.SETPOINT').first().waitFor();
  await visit(page, server, 'process');
});
