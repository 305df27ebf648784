// Values that the page itself does not send: they are told as a refusal of the CPU is, and go with the next success.
import { translator } from '../i18n';
import { variables } from '../i18n/texts/variables';
import { messages } from './messages.svelte';
import type { Beyond } from './number_range';

const t = translator(variables);

export const beyondText = (one: Beyond): string => t('beyond', { ...one });

export function refuse(values: readonly Beyond[]): void {
  for (const one of values.slice(0, 3)) messages.problem({ text: beyondText(one) }, 'variables.write');
}
