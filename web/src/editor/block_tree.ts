// The rows of the block tree: each block, and below it what it calls.
import type { BlockRow } from '../connection/protocol';

export interface TreeRow {
  key: string; // way through the calls, unique
  id: string;
  block: BlockRow | undefined; // undefined: called but not there
  depth: number;
  expandable: boolean;
  expanded: boolean;
}

const kinds = ['OB', 'PB', 'SB', 'FB', 'FC', 'DB', 'UDT', 'SFB', 'SFC'];

const order = (id: string): [kind: number, number: number] => {
  const [, kind = '', number = '0'] = /^(\w+) (\d+)/.exec(id) ?? [];
  return [kinds.indexOf(kind), Number(number)];
};

export function compareIds(a: string, b: string): number {
  const [kindA, numberA] = order(a);
  const [kindB, numberB] = order(b);
  return kindA - kindB || numberA - numberB;
}

export function treeRows(blocks: readonly BlockRow[], expanded: ReadonlySet<string>): TreeRow[] {
  const byId = new Map(blocks.map((block) => [block.id, block]));
  const rows: TreeRow[] = [];
  const add = (id: string, above: readonly string[]): void => {
    const block = byId.get(id);
    const key = [...above, id].join('/');
    // A block that calls itself, directly or through others, is not unfolded again.
    const expandable = (block?.calls.length ?? 0) > 0 && !above.includes(id);
    const open = expandable && expanded.has(key);
    rows.push({ key, id, block, depth: above.length, expandable, expanded: open });
    if (open) for (const called of block!.calls) add(called, [...above, id]);
  };
  for (const id of [...byId.keys()].sort(compareIds)) add(id, []);
  return rows;
}
