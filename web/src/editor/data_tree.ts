// The variables of a data block as a tree: structures and arrays hold theirs, folded until somebody looks into them.
import type { DataRow, DataStructure } from '../connection/protocol';

export interface DataNode {
  /** The path of the variable, or as much of it as names the structure. */
  key: string;
  name: string;
  depth: number;
  /** Missing of a structure or array. */
  row?: DataRow;
  kind?: 'STRUCT' | 'ARRAY';
  expanded: boolean;
  /** IN, STAT and so on, of what is declared in the block itself. */
  section: string;
  /** Where it begins. */
  address: string;
}

/** "a.b[1,2].c" is a, b, [1,2], c; each with the path up to it. */
export function partsOf(path: string): { name: string; key: string }[] {
  const parts: { name: string; key: string }[] = [];
  for (const match of path.matchAll(/\[[^\]]*\]|[^.[]+/g))
    parts.push({ name: match[0], key: path.slice(0, match.index + match[0].length) });
  return parts;
}

export function dataTree(rows: readonly DataRow[], expanded: ReadonlySet<string>): DataNode[] {
  const nodes: DataNode[] = [];
  let open: string[] = [];
  for (const row of rows) {
    const parts = partsOf(row.path);
    const groups = parts.slice(0, -1);
    let folded = false;
    for (const [depth, { name, key }] of groups.entries()) {
      const isNew = open[depth] !== key;
      if (isNew && !folded)
        nodes.push({
          key,
          name,
          depth,
          kind: parts[depth + 1]!.name.startsWith('[') ? 'ARRAY' : 'STRUCT',
          expanded: expanded.has(key),
          section: depth === 0 ? row.section : '',
          address: row.address,
        });
      folded ||= !expanded.has(key);
    }
    open = groups.map(({ key }) => key);
    const { name, key } = parts.at(-1) ?? { name: row.path, key: row.path };
    const depth = groups.length;
    const section = depth === 0 ? row.section : '';
    if (!folded) nodes.push({ key, name, depth, row, expanded: false, section, address: row.address });
  }
  return nodes;
}

/** Whether there is something to fold. */
export const groupsOf = (rows: readonly DataRow[]): string[] => [
  ...new Set(
    rows.flatMap((row) =>
      partsOf(row.path)
        .slice(0, -1)
        .map(({ key }) => key),
    ),
  ),
];

/** "[1,2]" and "[3,4]" are "ARRAY[1..3, 2..4]". */
function bounds(first: string, last: string): string {
  const [from, to] = [first, last].map((index) => index.slice(1, -1).split(','));
  return from!.map((low, at) => `${low.trim()}..${to![at]!.trim()}`).join(', ');
}

/** What a structure is: a data type or an instance, by the path with the indices left out; else STRUCT. */
export function structureTypes(structures: readonly DataStructure[]): (key: string) => string {
  const types = new Map(structures.map(({ path, type }) => [path, type]));
  return (key) => types.get(key.replace(/\[[^\]]*\]/g, '[]')) ?? 'STRUCT';
}

/** What arrays are, by their paths, as far as the rows tell; of one that is cut off nobody knows the end. */
export function arrayTypes(
  rows: readonly DataRow[],
  complete: boolean,
  structure: (key: string) => string = () => 'STRUCT',
): Map<string, string> {
  const ends = new Map<string, { first: string; last: string; of: string }>();
  for (const row of rows) {
    const parts = partsOf(row.path);
    for (const [at, { name }] of parts.entries()) {
      const array = parts[at - 1]?.key;
      if (!array || !name.startsWith('[')) continue;
      const known = ends.get(array);
      if (known) known.last = name;
      else
        ends.set(array, { first: name, last: name, of: at === parts.length - 1 ? row.type : structure(`${array}[]`) });
    }
  }
  const cut = complete ? '' : (rows.at(-1)?.path ?? '');
  return new Map(
    [...ends].flatMap(([path, { first, last, of }]) =>
      cut.startsWith(`${path}[`) ? [] : [[path, `ARRAY[${bounds(first, last)}] OF ${of}`] as const],
    ),
  );
}
