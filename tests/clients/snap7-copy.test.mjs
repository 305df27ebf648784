// Up from one Merker, down into another: all blocks of a program (S7-NET-26, S7-LIM-04).
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { Plc, snap7Client, until } from './plc.mjs';

const EXAMPLES = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../examples');
const EMPTY = 'ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n';

// Containers by type and number, in the order in which blocks are loaded: OBs last.
async function blocksOf(client) {
  const all = new Map();
  for (const type of ['SDB', 'DB', 'FC', 'FB', 'OB']) {
    const kind = client[`Block_${type}`];
    const counts = await client.call('ListBlocks');
    if (counts[`${type}Count`] === 0) continue;
    for (const number of await client.call('ListBlocksOfType', kind))
      all.set(`${type} ${number}`, { number, container: await client.call('FullUpload', kind, number, 65_536) });
  }
  return all;
}

async function stopped(options) {
  const plc = await Plc.start(options);
  const client = await snap7Client(plc);
  await client.call('PlcStop');
  return { plc, client };
}

async function copied(example, contains) {
  const from = await stopped({ path: join(EXAMPLES, example) });
  const into = await stopped({ files: { 'a.awl': EMPTY } });
  try {
    const blocks = await blocksOf(from.client);
    for (const name of contains) assert.ok(blocks.has(name), `${[...blocks.keys()]}`);
    for (const { number, container } of blocks.values()) await into.client.call('Download', number, Buffer.from(container));
    assert.deepEqual(await blocksOf(into.client), blocks);
    assert.deepEqual(await into.client.call('ListBlocks'), await from.client.call('ListBlocks'));
    await into.client.call('PlcHotStart');
    await until(() => into.client.call('PlcStatus'), (mode) => mode === into.client.S7CpuStatusRun);
  } finally {
    for (const { plc, client } of [from, into]) {
      client.Disconnect();
      await plc.end();
    }
  }
}

test('the lift', { timeout: 60_000 }, () => copied('lift', ['OB 1', 'SDB 0']));
test('the sorting plant', { timeout: 60_000 }, () => copied('sorting-plant', ['OB 1', 'SDB 1']));
