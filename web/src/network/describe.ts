// An element in words, for screen readers and as its name.
import { translator } from '../i18n';
import { networks } from '../i18n/texts/networks';
import type { Item } from './items';
import type { View } from './networks.svelte';

const t = translator(networks);

/** What FUP draws as a box though it takes what comes out. */
const outputs = /^(=|S|R|#)$/;

/** `FB 1, DB 1` names its block itself. */
const boxName = ({ name, operand }: Item, between = ' '): string =>
  operand === undefined ? name : operand.startsWith(name) ? operand : `${name}${between}${operand}`;

/** `items`: of the network, for the names of its boxes. */
export function describe(item: Item, view: View, items: readonly Item[]): string {
  const { kind, name, operand = '', pin, of } = item;
  if (kind === 'contact') {
    if (name === 'NOT') return t('not');
    return t(name === '/' ? 'closer' : 'contact', { operand });
  }
  if (kind === 'wire') return t('junction');
  if (kind === 'coil') return t('coil', { name: name.trim() || '=', operand });
  if (kind === 'frame') {
    if (item.operand !== undefined && outputs.test(name.trim())) return t('output', { name: name.trim(), operand });
    return t('box', { name: boxName(item, ', ') });
  }
  const box = of && items.find((one) => one.kind === 'frame' && one.node === of.box);
  if (box && of) return t(of.side, { pin: of.pin, box: boxName(box), operand: operand || t('nothing') });
  return t(view === 'fup' && pin === 0 ? 'input' : 'operand', { operand: operand || '…' });
}
