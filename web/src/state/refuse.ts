// Values that the page itself does not send: they are told as a refusal of the CPU is, and go with the next success.
import { translator } from '../i18n';
import { variables } from '../i18n/texts/variables';
import { messages } from './messages.svelte';
import type { Beyond } from './number_range';

const t = translator(variables);

export function refuse(values: readonly Beyond[]): void {
  const problems = values.map((one) => ({ text: t('beyond', { ...one }) }));
  for (const problem of problems.slice(0, 3)) messages.problem(problem, 'variables.write');
}
