// Why the statements of a block have no status now.
import { translator } from '../i18n';
import { program } from '../i18n/texts/program';
import { plc } from '../state/plc.svelte';

const t = translator(program);

/** `old`: the text differs from what the CPU has. */
export function whyNoStatus(old: boolean): string {
  if (old) return t('statusOld');
  if (plc.mode === 'STOP') return t('statusStopped');
  return t(plc.stands ? 'statusStands' : 'statusNotRunning');
}
