// S7Endpoint of @st-one-io/nodes7, what Node-RED's S7 nodes stand on: everything that it offers (S7-NET-26).
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { Plc, require, until } from './plc.mjs';

const { S7Endpoint, S7ItemGroup } = require('@st-one-io/nodes7');
let plc, endpoint;

before(async () => {
  plc = await Plc.start();
  endpoint = new S7Endpoint({ host: '127.0.0.1', port: plc.port, rack: 0, slot: 2, autoReconnect: 0 });
  const connected = new Promise((resolve, reject) => endpoint.once('connect', resolve).once('error', reject));
  await endpoint.connect();
  await connected;
});

after(async () => {
  await endpoint.disconnect();
  assert.match(await plc.end(), / 0 refused, 0 broken off, /);
});

test('areas', { timeout: 30_000 }, async () => {
  assert.equal(endpoint.pduSize, 240);
  assert.equal((await endpoint.readDB(1, 0, 10)).toString('hex'), '00053fc00000fffeee90');
  await endpoint.writeDB(1, 0, Buffer.from('1234', 'hex'));
  assert.equal((await endpoint.readDB(1, 0, 2)).toString('hex'), '1234');
  await endpoint.writeFlags(200, Buffer.from('deadbeef', 'hex'));
  assert.equal((await endpoint.readFlags(0, 256)).subarray(200, 204).toString('hex'), 'deadbeef'); // more than a PDU
  await endpoint.writeArea(0x81, 0, Buffer.from([1]));
  await until(() => endpoint.readOutputs(0, 1), (outputs) => outputs[0] === 1);
  assert.equal((await endpoint.readInputs(0, 1))[0], 1);
  await endpoint.writeOutputs(100, Buffer.from([0x5a]));
  assert.equal((await endpoint.readArea(0x82, 100, 1))[0], 0x5a);
  await assert.rejects(endpoint.readDB(7, 0, 1));
});

test('items of a group', { timeout: 30_000 }, async () => {
  const group = new S7ItemGroup(endpoint);
  const tags = { number: 'DB1,INT0', level: 'DB1,REAL2', large: 'DB1,DINT6', on: 'DB1,X10.0', text: 'DB1,S12.8', cycles: 'MW20', output: 'QB0' };
  group.setTranslationCB((name) => tags[name]);
  group.addItems(Object.keys(tags));
  await group.writeItems(['number', 'level'], [-7, 1.5]);
  const { cycles, ...values } = await group.readAllItems();
  assert.deepEqual(values, { number: -7, level: 1.5, large: -70000, on: true, text: 'box', output: 1 });
  await until(() => group.readAllItems(), (now) => now.cycles !== cycles);
  group.removeItems('text');
  assert.equal('text' in (await group.readAllItems()), false);
  group.destroy();
});

test('blocks', { timeout: 30_000 }, async () => {
  const { SFC, SFB, ...counts } = await endpoint.blockCount();
  assert.deepEqual(counts, { OB: 1, FB: 1, FC: 1, DB: 1, SDB: 2 });
  const all = await endpoint.listAllBlocks();
  const numbers = Object.fromEntries(Object.entries(all).map(([type, list]) => [type, list.map((block) => block.number)]));
  assert.deepEqual([numbers.OB, numbers.FB, numbers.FC, numbers.DB, numbers.SDB], [[1], [1], [1], [1], [0, 2]]);
  assert.deepEqual([numbers.SFC.length, numbers.SFB.length], [SFC, SFB]); // more than a PDU holds
  const information = await endpoint.getAllBlockInfo();
  assert.equal(information.length, 6 + SFC + SFB);
  assert.ok(information.every((one) => one.length > 70));
  const blocks = await endpoint.uploadAllBlocks(); // SFC and SFB are the CPU's own
  assert.deepEqual(blocks.map((block) => `${block[5].toString(16)} ${block.readUInt16BE(6)}`), ['8 1', 'a 1', 'b 0', 'b 2', 'c 1', 'e 1']);
  for (const block of blocks) {
    assert.equal(block.readUInt16BE(0), 0x7070);
    assert.equal(block.readUInt32BE(8), block.length); // the length that its head names
  }
  const head = await endpoint.uploadBlock('OB', 1, true);
  assert.deepEqual(head, blocks[0].subarray(0, 36));
  assert.equal((await endpoint.uploadBlock('SFC', 51, true)).readUInt16BE(6), 51);
  await assert.rejects(endpoint.uploadBlock('SFC', 51));
  await assert.rejects(endpoint.uploadBlock('FB', 9));
  await assert.rejects(endpoint.uploadBlock('FB', 9, true));
  await assert.rejects(endpoint.getBlockInfo('FB', 9));
});

test('the system status', { timeout: 30_000 }, async () => {
  const numbers = await endpoint.getAvailableSSL();
  assert.ok(numbers.includes(0x00a0));
  const records = (number) => endpoint.getSSL(number, 0).catch((error) => assert.equal(error.code, 0xd402)); // those without INDEX 0
  for (const number of numbers) await records(number);
  assert.equal((await endpoint.getModuleIdentification()).moduleOrderNumber, '6ES7 314-6BF01-0AB0');
  const names = await endpoint.getComponentIdentification();
  assert.deepEqual([names.plcName, names.moduleName], ['Merker', 'CPU 314C-2 PtP']);
  assert.equal((await endpoint.getSSL(0x0d91, 0, true))[0].toString('hex'), '000002007fff00c000c00000b4020011');
});

// Where the seconds belong setTime() writes the day of the week: 3 is Tuesday.
test('the clock', { timeout: 30_000 }, async () => {
  const time = new Date(2024, 11, 31, 23, 58, 0);
  await endpoint.setTime(time);
  const passed = (await endpoint.getTime()) - time;
  assert.ok(passed >= 3_000 && passed < 33_000, `${passed}`);
});
