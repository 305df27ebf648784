// The program structure: from each organization block down to what it calls, as STEP 7 shows it.
import type { BlockRow } from '../connection/protocol';
import { compareIds } from './block_tree';

export interface CallRow {
  key: string;
  id: string;
  block: BlockRow | undefined;
  depth: number;
  /** It calls itself, directly or through others; it has been unfolded above; nobody calls it. */
  mark: '' | 'recursive' | 'above' | 'unused';
}

/** Each block is unfolded once: a program where everybody calls everybody stays as long as it has calls. */
export function callTree(blocks: readonly BlockRow[]): CallRow[] {
  const byId = new Map(blocks.map((block) => [block.id, block]));
  const rows: CallRow[] = [];
  const done = new Set<string>();
  const add = (id: string, above: readonly string[], mark: CallRow['mark'] = ''): void => {
    const block = byId.get(id);
    const calls = block?.calls ?? [];
    const again = above.includes(id) ? 'recursive' : done.has(id) && calls.length > 0 ? 'above' : mark;
    rows.push({ key: `${rows.length}`, id, block, depth: above.length, mark: again });
    if (again === 'recursive' || again === 'above') return;
    done.add(id);
    for (const called of [...calls].sort(compareIds)) add(called, [...above, id]);
  };
  const code = [...byId.values()].filter(({ language }) => language !== 'DB' && language !== 'UDT');
  const roots = code.filter(({ id }) => id.startsWith('OB '));
  for (const { id } of [...roots].sort((a, b) => compareIds(a.id, b.id))) add(id, []);
  // Nobody reaches the others; of those that call each other the one is shown that calls.
  for (const { id } of [...code].sort((a, b) => compareIds(a.id, b.id))) if (!done.has(id)) add(id, [], 'unused');
  return rows;
}
