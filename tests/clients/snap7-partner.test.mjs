// Configured connections (S7-SFB-10, S7-NETPRO-08): BSEND and BRCV with Snap7's partner, which calls and is called; GET and PUT with
// its server. Both are programs of their own: the server of the package's addon ends Node.js now and then.
import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, test } from 'node:test';

import { freePort, Partner, project, sumOf } from './partner.mjs';
import { Plc, snap7Client, until } from './plc.mjs';

after(() => rmSync(`${process.env.MERKER_CLIENTS}/partner-${process.pid}`, { force: true }));

const word = async (client, byte) => (await client.call('MBRead', byte, 2)).readUInt16BE();
const put16 = (client, byte, value) => {
  const bytes = Buffer.alloc(2);
  bytes.writeUInt16BE(value);
  return client.call('MBWrite', byte, 2, bytes);
};
const bits = (client, value) => client.call('MBWrite', 0, 1, Buffer.from([value]));

// A BSEND of the CPU; what it counts then, or its STATUS.
async function send(client, rid, count) {
  const bytes = Buffer.from(Uint8Array.from({ length: count }, (_, i) => i + 1));
  await client.call('DBWrite', 1, 0, count, bytes);
  await client.call('MBWrite', 140, 4, Buffer.from([0, 0, 0, rid]));
  await put16(client, 110, count);
  await put16(client, 112, 0);
  const before = await word(client, 100);
  await bits(client, 0x05);
  const status = await until(
    async () => ((await word(client, 100)) === before ? word(client, 112) : 'done'),
    (now) => now !== 0,
  );
  await bits(client, 0x04);
  return status;
}

async function bothWays(client, partner) {
  for (const count of [1, 480, 65_000]) {
    const received = partner.ask('receive');
    assert.equal(await send(client, 9, count), 'done');
    assert.equal(await received, `got 9 ${count} ${sumOf(count)}`);
    const before = await word(client, 102);
    assert.equal(await partner.ask(`send 7 ${count}`), 'sent');
    await until(() => word(client, 102), (now) => now !== before);
    assert.equal(await word(client, 108), count);
    const bytes = await client.call('DBRead', 2, 0, count);
    assert.equal(bytes.reduce((sum, byte, i) => sum + byte * (1 + (i % 7)), 0), sumOf(count));
  }
}

// BRCV is there, and has the connection.
async function ready(client) {
  await bits(client, 0x04);
  await until(() => word(client, 152), (status) => status === 25);
}

async function withPlc(lines, run) {
  const plc = await Plc.start({ files: project(lines) });
  const client = await snap7Client(plc);
  try {
    await run(client, plc);
  } finally {
    client.Disconnect();
    await plc.end();
  }
}

test('the CPU calls', { timeout: 120_000 }, async () => {
  const port = await freePort();
  const partner = await Partner.start(`passive ${port} 1002 1003`);
  await withPlc(`partner = "tcp://127.0.0.1:${port}"\nlocal_tsap = "10.03"`, async (client) => {
    await ready(client);
    await bothWays(client, partner);
  });
  await partner.kill();
});

test('the partner calls', { timeout: 120_000 }, async () => {
  const lines = 'partner = "tcp://127.0.0.1"\nactive = false\nlocal_tsap = "10.02"\npartner_tsap = "11.00"';
  await withPlc(lines, async (client, plc) => {
    let partner = await Partner.start(`active ${plc.port} 1100 1002`);
    await ready(client);
    await bothWays(client, partner);
    // Refused, as nobody has this R_ID: Snap7 gives up its connection and calls again.
    await put16(client, 114, 0);
    await partner.ask('send 99 300');
    await until(() => word(client, 114), (status) => status === 1);
    await ready(client);
    await bothWays(client, partner);
    // Lost in the middle, and built up again.
    await put16(client, 114, 0);
    partner.process.stdin.write('send 7 65000\n');
    await partner.kill();
    await until(() => word(client, 114), (status) => status === 1);
    assert.equal(await send(client, 9, 10), 1);
    partner = await Partner.start(`active ${plc.port} 1100 1002`);
    await ready(client);
    await bothWays(client, partner);
    await partner.kill();
  });
});

test('GET and PUT', { timeout: 120_000 }, async () => {
  const port = await freePort();
  const server = await Partner.start(`server ${port}`);
  await withPlc(`partner = "tcp://127.0.0.1:${port}"`, async (client) => {
    await until(() => word(client, 152), (status) => status === 0);
    const mine = Buffer.alloc(100, 0x5a);
    await client.call('DBWrite', 1, 0, 100, mine);
    // Edges of REQ, until the connection is there.
    const tried = (bit, counted) =>
      until(
        async () => {
          await bits(client, 0);
          await bits(client, bit);
          return word(client, counted);
        },
        (count) => count > 0,
      );
    await tried(0x08, 104);
    assert.deepEqual([...(await client.call('DBRead', 2, 0, 100))], [...Array(100).keys()].map((i) => i + 10));
    assert.equal((await client.call('MBRead', 160, 2)).toString('hex'), '6e6f');
    await tried(0x10, 106);
    assert.equal(await server.ask('bytes 200 102'), `${mine.toString('hex')}2c2d`); // behind it nothing has changed
  });
  await server.kill();
});
