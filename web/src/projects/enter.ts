// The page enters the PLC of its address; where there is none such, it says so and is at the first one.
import { connection } from '../connection';
import { enterPlc, pageAt, type Entrance } from '../connection/plcs';
import { translator } from '../i18n';
import { projects } from '../i18n/texts/projects';
import { messages } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';

const t = translator(projects);

export function enterOwnPlc(): Entrance {
  const asked = new URL(location.href).searchParams.get('plc') ?? '';
  return enterPlc(connection, location.href, (first) => {
    const view = location.hash.replace(/^#\//, '');
    history.replaceState(null, '', pageAt(location.href, 1, view));
    messages.problem({ text: t('plcUnknown', { plc: asked }) });
    if (Object.keys(first).length > 0) plc.receive(first);
  });
}
