// Why a status value is "?".

import { translator } from '../i18n';
import { variables } from '../i18n/texts/variables';
import type { Watched } from '../state/watch.svelte';

const t = translator(variables);

/** Empty where there is a value, or none has come yet. */
export function unread({ text, address, sent }: Pick<Watched, 'text' | 'address' | 'sent'>): string {
  if (!sent || text !== '?') return '';
  const data = /^(D[BI]) ?(\d+)/.exec(address);
  if (data) return t('noBlock', { block: `${data[1]} ${data[2]}` });
  return /^P/.test(address) ? t('noModule') : t('noValueNow');
}
