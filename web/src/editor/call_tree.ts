// The program structure: from each organization block down to what it calls and uses, as STEP 7 shows it.
import type { BlockRow, StructureRow, UsedBlock } from '../connection/protocol';
import { compareIds } from './block_tree';

export interface CallRow {
  key: string;
  id: string;
  /** The data block that a CALL names. */
  instance: string;
  block: BlockRow | undefined;
  depth: number;
  /** Bytes of local data, of the block itself and with those of all above it; undefined: it has none. */
  local: number | undefined;
  path: number | undefined;
  /** It calls itself, directly or through others; it has been unfolded above; nobody calls or opens it; the CPU has it, a library, or nobody. */
  mark: '' | 'recursive' | 'above' | 'unused' | 'unopened' | 'ofCpu' | 'ofLibrary' | 'missing';
}

const marks = { program: '', cpu: 'ofCpu', library: 'ofLibrary', missing: 'missing' } as const;
const order = (a: UsedBlock, b: UsedBlock): number =>
  compareIds(a.id, b.id) || compareIds(a.instance ?? '', b.instance ?? '');

/** Each block is unfolded once: a program where everybody calls everybody stays as long as it has calls. */
export function callTree(blocks: readonly BlockRow[], structure: readonly StructureRow[]): CallRow[] {
  const known = new Map(blocks.map((block) => [block.id, block]));
  const byId = new Map(structure.map((row) => [row.id, row]));
  const rows: CallRow[] = [];
  const done = new Set<string>();
  const add = (
    { id, instance = '' }: UsedBlock,
    above: readonly string[],
    path: number,
    mark: CallRow['mark'],
  ): void => {
    const code = byId.get(id);
    const uses = code?.uses ?? [];
    const again = above.includes(id) ? 'recursive' : done.has(id) && uses.length > 0 ? 'above' : mark;
    const local = code?.local;
    const sum = path + (local ?? 0);
    const block = known.get(id);
    const depth = above.length;
    rows.push({
      key: `${rows.length}`,
      id,
      instance,
      block,
      depth,
      local,
      path: code && local !== undefined ? sum : undefined,
      mark: again,
    });
    if (again === 'recursive' || again === 'above') return;
    done.add(id);
    for (const used of [...uses].sort(order)) add(used, [...above, id], sum, marks[used.from]);
  };
  const ids = [...byId.keys()].sort(compareIds);
  const start = (id: string, mark: CallRow['mark']): void => add({ id, from: 'program' }, [], 0, mark);
  for (const id of ids) if (id.startsWith('OB ')) start(id, '');
  // Nobody reaches the others; of those that call each other the one is shown that calls.
  for (const id of ids) if (!done.has(id)) start(id, 'unused');
  const instances = new Set(rows.map(({ instance }) => instance));
  const data = [...known.keys()].filter((id) => id.startsWith('DB ')).sort(compareIds);
  for (const id of data) if (!done.has(id) && !instances.has(id)) start(id, 'unopened');
  return rows;
}

/**
 * The most local data that a path from this block takes, in bytes; a block that calls itself counts once.
 * Undefined where there is none.
 */
export function deepest(structure: readonly StructureRow[]): (id: string) => number | undefined {
  const byId = new Map(structure.map((row) => [row.id, row]));
  const found = new Map<string, number>();
  const of = (id: string): number => {
    const old = found.get(id);
    if (old !== undefined) return old;
    found.set(id, 0); // while it is looked for
    const row = byId.get(id);
    const below = (row?.uses ?? []).map((used) => of(used.id));
    const most = (row?.local ?? 0) + Math.max(0, ...below);
    found.set(id, most);
    return most;
  };
  return (id) => (byId.get(id)?.local === undefined ? undefined : of(id));
}
