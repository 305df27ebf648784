// The palette as groups, filtered by what was typed: names in the mnemonics of the text, SE is another timer in the other ones.
import type { NetworkElement } from '../connection/protocol';

type Group = NetworkElement['group'];

export interface PaletteEntry {
  id: string;
  name: string;
  key: string | undefined;
  /** Its name in the other mnemonics, if it was found by that one. */
  other: string | undefined;
}
export interface PaletteGroup {
  id: Group;
  elements: PaletteEntry[];
}

const order: readonly Group[] = ['bit', 'coil', 'box', 'compare', 'move', 'call'];

// "(R)" is found by "r" as well.
const plain = (name: string) => name.toLowerCase().replace(/[^a-z0-9]/g, '');
const isExactly = (name: string, typed: string) =>
  name.toLowerCase() === typed || (plain(typed) !== '' && plain(name) === plain(typed));

/** Names in the other mnemonics, and ids, count only if nothing has exactly the typed name. */
export function grouped(elements: readonly NetworkElement[], view: 'kop' | 'fup', filter: string): PaletteGroup[] {
  const typed = filter.trim().toLowerCase();
  const has = (name: string) => name.toLowerCase().includes(typed);
  const named = elements.filter((element) => element[view] !== '');
  const exact = named.some((element) => isExactly(element[view], typed));
  const found = named.flatMap((element) => {
    const { id, group, key, other } = element;
    const own = has(element[view]);
    const byOther = !own && !exact && other !== undefined && has(other[view]);
    if (!own && !byOther && (exact || !has(id))) return [];
    return [{ group, entry: { id, name: element[view], key, other: byOther ? other[view] : undefined } }];
  });
  return order
    .map((id) => ({ id, elements: found.filter(({ group }) => group === id).map(({ entry }) => entry) }))
    .filter((group) => group.elements.length > 0);
}

/** What Enter takes: the element of that name, as a box or as a coil, then one that begins so, otherwise the first one. */
export function bestOf(groups: readonly PaletteGroup[], filter: string): PaletteEntry | undefined {
  const typed = filter.trim().toLowerCase();
  const all = groups.flatMap(({ elements }) => elements);
  const begins = (name: string) => plain(typed) !== '' && plain(name).startsWith(plain(typed));
  return (
    all.find(({ name }) => name.toLowerCase() === typed) ??
    all.find(({ name }) => isExactly(name, typed)) ??
    all.find(({ other }) => other !== undefined && isExactly(other, typed)) ??
    all.find(({ name }) => begins(name)) ??
    all[0]
  );
}
