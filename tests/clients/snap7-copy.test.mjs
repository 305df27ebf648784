// Up from one Merker, down into another: all blocks of a program (S7-NET-26, S7-LIM-04), also as their memory cards have them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { Plc, snap7Client, until } from './plc.mjs';

const EXAMPLES = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../examples');
const EMPTY = 'ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n';

const cards = mkdtempSync(join(tmpdir(), 'merker-'));
after(() => rmSync(cards, { recursive: true }));

// Each PLC has its configuration of its own.
function list(card) {
  const { blocks } = JSON.parse(execFileSync(process.env.MERKER, ['list', '--card', card, '--json']));
  return blocks.filter(({ block }) => !block.startsWith('SDB'));
}

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
  const [oldCard, newCard] = ['old', 'new'].map((name) => join(cards, `${example}.${name}`));
  const from = await stopped({ path: join(EXAMPLES, example), card: oldCard });
  const into = await stopped({ files: { 'a.awl': EMPTY }, card: newCard });
  try {
    await from.client.call('CopyRamToRom', 10_000); // the values that an upload has
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
  assert.ok(list(oldCard).some(({ block }) => block === contains[0]));
  assert.deepEqual(list(newCard), list(oldCard));
}

test('the lift', { timeout: 60_000 }, () => copied('lift', ['OB 1', 'SDB 0']));
test('the sorting plant', { timeout: 60_000 }, () => copied('sorting-plant', ['OB 1', 'SDB 1']));
