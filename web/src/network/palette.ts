// The palette as groups, filtered by what was typed.
import type { NetworkElement } from '../connection/protocol';

type Group = NetworkElement['group'];

export interface PaletteGroup {
  id: Group;
  elements: { id: string; name: string; key: string | undefined }[];
}

const order: readonly Group[] = ['bit', 'coil', 'box', 'compare', 'move', 'call'];

export function grouped(elements: readonly NetworkElement[], view: 'kop' | 'fup', filter: string): PaletteGroup[] {
  const typed = filter.trim().toLowerCase();
  const found = elements
    .map((element) => ({ ...element, name: element[view] }))
    .filter(({ id, name }) => name !== '' && `${id} ${name}`.toLowerCase().includes(typed));
  return order
    .map((id) => ({
      id,
      elements: found.filter(({ group }) => group === id).map(({ id, name, key }) => ({ id, name, key })),
    }))
    .filter((group) => group.elements.length > 0);
}

// "(R)" is found by "r" as well.
const plain = (name: string) => name.toLowerCase().replace(/[^a-z0-9]/g, '');

/** What Enter takes: the element of that name, as a box or as a coil, then one that begins so, otherwise the first one. */
export function bestOf(groups: readonly PaletteGroup[], filter: string): PaletteGroup['elements'][number] | undefined {
  const typed = filter.trim().toLowerCase();
  const all = groups.flatMap(({ elements }) => elements);
  const short = plain(typed);
  return (
    all.find(({ name }) => name.toLowerCase() === typed) ??
    (short === '' ? undefined : all.find(({ name }) => plain(name) === short)) ??
    (short === '' ? undefined : all.find(({ name }) => plain(name).startsWith(short))) ??
    all[0]
  );
}
