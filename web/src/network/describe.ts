// An element in words, for screen readers and as its name.
import { translator } from '../i18n';
import { networks } from '../i18n/texts/networks';
import type { Item } from './items';
import type { View } from './networks.svelte';

const t = translator(networks);

export function describe(item: Item, view: View): string {
  const { kind, name, operand = '', pin } = item;
  if (kind === 'contact') {
    if (name === 'NOT') return t('not');
    return t(name === '/' ? 'closer' : 'contact', { operand });
  }
  if (kind === 'coil') return t('coil', { name: name.trim() || '=', operand });
  if (kind === 'frame') return t('box', { name: item.operand === undefined ? name : `${name}, ${operand}` });
  return t(view === 'fup' && pin === 0 ? 'input' : 'operand', { operand: operand || '…' });
}
