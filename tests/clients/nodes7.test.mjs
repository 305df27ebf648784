// nodes7: many items at once, several requests at the same time (S7-NET-26).
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { Plc, require, until } from './plc.mjs';

const Nodes7 = require('nodes7');
let plc, connection;

const ITEMS = ['DB1,INT0', 'DB1,REAL2', 'DB1,DINT6', 'DB1,X10.0', 'DB1,X10.1', 'DB1,S12.8', 'MW20', 'QB0', 'I0.0', 'C0', 'MW200'];

before(async () => {
  plc = await Plc.start();
  connection = new Nodes7({ silent: true });
  await new Promise((resolve, reject) =>
    connection.initiateConnection({ port: plc.port, host: '127.0.0.1', rack: 0, slot: 2 }, (error) =>
      error ? reject(error) : resolve(),
    ),
  );
});

after(async () => {
  await new Promise((resolve) => connection.dropConnection(resolve));
  assert.match(await plc.end(), / 0 refused, 0 broken off, /);
});

const read = () =>
  new Promise((resolve) => connection.readAllItems((bad, values) => resolve({ bad, ...values })));
const write = (items, values) =>
  new Promise((resolve) => connection.writeItems(items, values, (bad) => resolve(bad)));

test('values of all areas', { timeout: 30_000 }, async () => {
  connection.addItems(ITEMS);
  const values = await read();
  assert.equal(values.bad, false);
  assert.deepEqual(
    ITEMS.slice(0, 6).map((item) => values[item]),
    [5, 1.5, -70000, true, false, 'box'],
  );
  assert.equal(values.C0, 0x42); // of others it multiplies the number by 8
  await until(read, (now) => now.MW20 !== values.MW20);
});

test('what is written is read', { timeout: 30_000 }, async () => {
  assert.equal(await write(['DB1,INT0', 'DB1,REAL2', 'MW200'], [-7, -0.25, 1234]), false);
  const values = await read();
  assert.deepEqual([values['DB1,INT0'], values['DB1,REAL2'], values.MW200], [-7, -0.25, 1234]);
  assert.equal(await write('I0.0', true), false);
  await until(read, (now) => now.QB0 === 1 && now['I0.0'] === true);
});

test('what is not there is bad', { timeout: 30_000 }, async () => {
  connection.addItems('DB7,INT0');
  const values = await read();
  assert.equal(values.bad, true);
  assert.equal(values['DB7,INT0'], 'BAD 255');
  assert.equal(values['DB1,REAL2'], -0.25);
  connection.removeItems('DB7,INT0');
});
