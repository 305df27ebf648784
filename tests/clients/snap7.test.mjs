// The client of Snap7: areas, several variables in a request, timers and counters (S7-NET-26).
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { Plc, snap7Client, until } from './plc.mjs';

let plc, client, call;

before(async () => {
  plc = await Plc.start();
  client = await snap7Client(plc);
  call = client.call;
});

after(async () => {
  client.Disconnect();
  assert.match(await plc.end(), / 0 refused, 0 broken off, /);
});

test('a PDU has 240 bytes', () => {
  assert.equal(client.PDULength(), 240);
});

test('areas', { timeout: 30_000 }, async () => {
  assert.equal((await call('DBRead', 1, 0, 10)).toString('hex'), '00053fc00000fffeee90');
  await call('DBWrite', 1, 0, 2, Buffer.from('1234', 'hex'));
  assert.equal((await call('DBRead', 1, 0, 2)).toString('hex'), '1234');
  await call('MBWrite', 200, 4, Buffer.from('deadbeef', 'hex'));
  assert.equal((await call('MBRead', 200, 4)).toString('hex'), 'deadbeef');
  await call('EBWrite', 0, 1, Buffer.from([1]));
  await until(() => call('ABRead', 0, 1), (outputs) => outputs[0] === 1);
  assert.equal((await call('EBRead', 0, 1))[0], 1);
  await call('ABWrite', 100, 2, Buffer.from('a55a', 'hex'));
  assert.equal((await call('ABRead', 100, 2)).toString('hex'), 'a55a');
});

// All flags are more than a PDU holds: the client asks several times.
test('more than a PDU', { timeout: 30_000 }, async () => {
  const flags = await call('MBRead', 0, 256);
  assert.equal(flags.length, 256);
  assert.equal(flags.subarray(200, 204).toString('hex'), 'deadbeef');
  const other = Buffer.alloc(256 - 100, 0x5a);
  await call('MBWrite', 100, other.length, other);
  assert.deepEqual((await call('MBRead', 0, 256)).subarray(100), other);
});

// Snap7 gives both as they are on the wire: BCD, a timer with its base (S5TIME).
test('timers and counters', { timeout: 30_000 }, async () => {
  assert.equal((await call('CTRead', 1, 1)).toString('hex'), '0042');
  const timer = await call('TMRead', 1, 1);
  assert.equal(timer[0] >> 4, 1); // 100 ms
  await call('CTWrite', 2, 1, Buffer.from('0123', 'hex'));
  assert.equal((await call('CTRead', 2, 1)).toString('hex'), '0123');
  await call('TMWrite', 2, 1, Buffer.from('2050', 'hex'));
  assert.equal((await call('TMRead', 2, 1)).toString('hex'), '2050');
});

test('several variables in a request', { timeout: 30_000 }, async () => {
  const variable = (Area, WordLen, DBNumber, Start, Amount, Data) => ({ Area, WordLen, DBNumber, Start, Amount, Data });
  const db = client.S7AreaDB, flags = client.S7AreaMK, byte = client.S7WLByte, bit = client.S7WLBit;
  const written = await call('WriteMultiVars', [
    variable(flags, byte, 0, 100, 3, Buffer.from([1, 2, 3])),
    variable(db, bit, 1, 81, 1, Buffer.from([1])),
    variable(db, byte, 7, 0, 1, Buffer.from([1])),
  ]);
  assert.deepEqual(written.map((one) => one.Result === 0), [true, true, false]);
  const read = await call('ReadMultiVars', [
    variable(flags, byte, 0, 100, 3),
    variable(db, bit, 1, 81, 1),
    variable(db, byte, 7, 0, 1),
    variable(client.S7AreaCT, client.S7WLCounter, 0, 2, 1),
  ]);
  assert.deepEqual([...read[0].Data], [1, 2, 3]);
  assert.equal(read[1].Data[0], 1);
  assert.match(client.ErrorText(read[2].Result), /Item not available/);
  assert.equal(read[3].Data.toString('hex'), '0123');
});

test('what is not there has a code', { timeout: 30_000 }, async () => {
  await assert.rejects(call('DBRead', 7, 0, 1), /Item not available/);
  await assert.rejects(call('MBRead', 4000, 1), /Address out of range/);
  await assert.rejects(call('DBRead', 1, 20, 10), /Address out of range/);
});

test('what it is and what it does', { timeout: 30_000 }, async () => {
  assert.equal((await call('GetOrderCode')).Code.trim(), '6ES7 314-6BF01-0AB0');
  const names = await call('GetCpuInfo');
  assert.equal(names.ModuleTypeName, 'CPU 314C-2 PtP');
  assert.equal(names.ModuleName, 'CPU 314C-2 PtP');
  assert.equal(names.ASName, 'Merker');
  const communication = await call('GetCpInfo');
  assert.deepEqual([communication.MaxPduLength, communication.MaxConnections], [240, 12]);
  assert.equal((await call('GetProtection')).sch_rel, 1);
  assert.equal(await call('PlcStatus'), client.S7CpuStatusRun);
});

// The diagnostic buffer has more than a PDU holds: it comes in parts.
test('lists', { timeout: 30_000 }, async () => {
  const numbers = await call('ReadSZLList');
  assert.ok(numbers.includes(0x0424), `${numbers}`);
  const memory = await call('ReadSZL', 0x0014, 0);
  assert.equal(memory.length, 4 + 8 * 8); // behind length and number of the records
  const rack = await call('ReadSZL', 0x0d91, 0);
  assert.equal(rack.subarray(4, 20).toString('hex'), '000002007fff00c000c00000b4020011'); // the CPU itself
  await assert.rejects(call('ReadSZL', 0x0999, 0));
});

// The addon leaves open whether it is daylight saving time: hours may differ by one.
test('the clock', { timeout: 30_000 }, async () => {
  const time = new Date(2024, 11, 31, 23, 59, 30);
  await call('SetPlcDateTime', time);
  const shown = await call('GetPlcDateTime');
  const hour = 3_600_000, passed = (shown - time + 2 * hour) % hour;
  assert.ok(Math.abs(shown - time) < 1.5 * hour && passed < 20_000, `${shown}`);
  await call('SetPlcSystemDateTime');
  assert.ok(Math.abs((await call('GetPlcDateTime')) - Date.now()) < 1.5 * hour);
});

// A panel is a client of another kind; with the TSAPs given one by one it is let in as well.
test('kinds of connections', { timeout: 30_000 }, async () => {
  for (const prepare of [
    (one) => one.SetConnectionType(one.CONNTYPE_OP),
    (one) => one.SetConnectionType(one.CONNTYPE_BASIC),
    (one) => one.SetConnectionParams('127.0.0.1', 0x0100, 0x0102) && 'knows',
  ]) {
    const other = await snap7Client(plc, prepare);
    assert.equal(await other.call('PlcStatus'), other.S7CpuStatusRun);
    assert.equal(other.GetParam(other.PDURequest), 480);
    assert.equal(other.PDURequested(), 480);
    assert.equal(other.LastError(), 0);
    assert.ok(other.ExecTime() < 30_000);
    other.Disconnect();
  }
});
