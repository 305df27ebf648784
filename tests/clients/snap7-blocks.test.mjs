// Blocks, control and protection by the client of Snap7 (S7-NET-26). Each test leaves the PLC in RUN.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { Plc, snap7Client, until } from './plc.mjs';

const limit = { timeout: 30_000 };
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

const running = () => until(() => call('PlcStatus'), (mode) => mode === client.S7CpuStatusRun);

test('stop and start', limit, async () => {
  await call('PlcStop');
  assert.equal(await call('PlcStatus'), client.S7CpuStatusStop);
  const count = await call('MBRead', 20, 2);
  assert.deepEqual(await call('MBRead', 20, 2), count);
  await assert.rejects(call('PlcStop'), /already STOP/);
  const diagnostics = await call('ReadSZL', 0x00a0, 0);
  assert.equal(diagnostics.subarray(4, 6).toString('hex'), '4304'); // STOP by a programming device
  await call('PlcHotStart');
  await running();
  await assert.rejects(call('PlcHotStart'), /already RUN/);
});

test('a cold restart is not of this CPU', limit, async () => {
  await call('PlcStop');
  await assert.rejects(call('PlcColdStart'), /Cannot start PLC/);
  await call('PlcHotStart');
  await running();
});

test('directory', limit, async () => {
  const counts = await call('ListBlocks');
  assert.deepEqual([counts.OBCount, counts.DBCount, counts.FCCount], [1, 1, 1]);
  assert.deepEqual([...(await call('ListBlocksOfType', client.Block_DB))], [1]);
  const information = await call('GetAgBlockInfo', client.Block_OB, 1);
  assert.deepEqual([information.BlkNumber, information.BlkLang], [1, 1]); // AWL
  await assert.rejects(call('GetAgBlockInfo', client.Block_FC, 9));
});

test('upload', limit, async () => {
  const container = await call('FullUpload', client.Block_OB, 1, 4096);
  const information = await call('GetAgBlockInfo', client.Block_OB, 1);
  assert.equal(container.length, information.LoadSize);
  assert.equal(container.subarray(0, 2).toString('hex'), '7070');
  assert.deepEqual(client.GetPgBlockInfo(container).MC7Size, information.MC7Size);
  assert.equal((await call('Upload', client.Block_OB, 1, 4096)).length, information.MC7Size);
  await assert.rejects(call('FullUpload', client.Block_FC, 9, 4096));
});

test('download and delete', limit, async () => {
  const container = await call('FullUpload', client.Block_DB, 1, 4096);
  await call('Download', 7, Buffer.from(container)); // under another number
  assert.deepEqual([...(await call('ListBlocksOfType', client.Block_DB))], [1, 7]);
  assert.equal((await call('DBRead', 7, 0, 2)).toString('hex'), '0005');
  await call('DBWrite', 7, 0, 2, Buffer.from('1234', 'hex'));
  await call('Download', 7, Buffer.from(container));
  assert.equal((await call('DBRead', 7, 0, 2)).toString('hex'), '0005');
  await call('Delete', client.Block_DB, 7);
  await assert.rejects(call('DBRead', 7, 0, 2), /Item not available/);
  await assert.rejects(call('Delete', client.Block_DB, 7));
  assert.deepEqual([...(await call('ListBlocksOfType', client.Block_DB))], [1]);
  await assert.rejects(call('Download', 60_000, Buffer.from(container))); // the CPU has no such number
});

test('values of a data block', limit, async () => {
  const values = await call('DBGet', 1);
  await call('DBFill', 1, 0x5a);
  assert.deepEqual(await call('DBGet', 1), Buffer.alloc(values.length, 0x5a));
  await call('DBWrite', 1, 0, values.length, values);
  assert.deepEqual(await call('DBGet', 1), values);
});

// Both take a limit of time for the answer, in ms.
test('memory', limit, async () => {
  await call('Compress', 10_000);
  await assert.rejects(call('CopyRamToRom', 10_000), /copy RAM to ROM/i); // not in RUN
  await call('PlcStop');
  await call('CopyRamToRom', 10_000);
  await call('PlcHotStart');
  await running();
});

test('a password', limit, async () => {
  await assert.rejects(call('SetSessionPassword', 'secret'), /Password/i); // the CPU has none
  const files = {
    'merker.toml': '[cpu]\nprotection = 3\npassword = "secret"\n',
    'a.awl': 'ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n',
  };
  const locked = await Plc.start({ files });
  const other = await snap7Client(locked);
  try {
    assert.equal((await other.call('GetProtection')).sch_rel, 3);
    await assert.rejects(other.call('FullUpload', other.Block_OB, 1, 4096), /not authorized/);
    await assert.rejects(other.call('Delete', other.Block_OB, 1), /not authorized/);
    await assert.rejects(other.call('PlcStop'));
    await other.call('SetSessionPassword', 'secret');
    const container = await other.call('FullUpload', other.Block_OB, 1, 4096);
    await other.call('Download', 1, container);
    await other.call('ClearSessionPassword');
    await assert.rejects(other.call('Download', 1, container), /not authorized/);
  } finally {
    other.Disconnect();
    await locked.end();
  }
});
