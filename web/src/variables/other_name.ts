// What an operand is called otherwise: the symbol of an address, the address of a symbol.
import { operandText } from '../i18n';
import type { Watched } from '../state/watch.svelte';
import type { Row } from './table';

type Named = Pick<Watched, 'address' | 'symbol'>;

export const otherNameOf = ({ operand }: Row, item: Named | undefined): string =>
  operand.includes('"') ? operandText(item?.address ?? '') : (item?.symbol ?? '');
