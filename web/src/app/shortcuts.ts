import { connection } from '../connection';
import { searching } from '../editor/searching.svelte';
import type { app } from '../i18n/texts/app';
import type { networks } from '../i18n/texts/networks';
import { attempt } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';
import { go, route } from './route.svelte';

export type Action = { kind: 'help' } | { kind: 'view'; number: number } | { kind: 'run'; run: () => void };

interface Key {
  keys: string;
  text: keyof typeof app;
}

/** What the help dialog lists. */
export const keys: Key[] = [
  { keys: 'F1', text: 'keyHelp' },
  { keys: 'Alt 1…9, 0', text: 'keyView' },
  { keys: 'Alt R', text: 'keyRun' },
  { keys: 'Alt S', text: 'keyStop' },
  { keys: 'Alt P', text: 'keyPause' },
  { keys: 'Alt N', text: 'keyStep' },
  { keys: 'Esc', text: 'keyEscape' },
  { keys: 'F6', text: 'keyPane' },
  { keys: 'Ctrl S', text: 'keySave' },
  { keys: 'Ctrl L', text: 'keyLoad' },
  { keys: 'Ctrl J', text: 'keySymbol' },
  { keys: 'Ctrl Shift F', text: 'keySearch' },
  { keys: 'F9', text: 'keyBreakpoint' },
  { keys: 'F8', text: 'keyGo' },
  { keys: 'F10', text: 'keyOver' },
  { keys: 'F11', text: 'keyInto' },
  { keys: 'F12', text: 'keyGoTo' },
  { keys: 'Alt F10', text: 'keyWhole' },
];

/** The same for KOP and FUP. */
export const networkKeys: { keys: string; text: keyof typeof networks }[] = [
  { keys: 'Ctrl 2', text: 'awlHelp' },
  { keys: 'Ctrl 1', text: 'kopHelp' },
  { keys: 'Ctrl 3', text: 'fupHelp' },
  { keys: 'F2', text: 'keyF2' },
  { keys: 'F3', text: 'keyF3' },
  { keys: 'F7', text: 'keyF7' },
  { keys: 'F8', text: 'keyF8' },
  { keys: 'F9', text: 'keyF9' },
  { keys: 'Alt F9', text: 'keyPalette' },
  { keys: 'Enter', text: 'keyEnter' },
  { keys: '← ↑ → ↓', text: 'keyArrows' },
  { keys: 'Home End', text: 'keyEnds' },
  { keys: 'Del', text: 'keyDelete' },
  { keys: 'Ctrl C X V', text: 'keyCopy' },
  { keys: 'Ctrl R', text: 'keyNetwork' },
  { keys: 'Ctrl Del', text: 'deleteNetwork' },
  { keys: 'Ctrl Z Y', text: 'keyUndo' },
];

const runs: Record<string, () => void> = {
  KeyR: () => void attempt(connection.ask('cpu.switch', { position: plc.lacks('modeSwitch') ? 'RUN' : 'RUN-P' })),
  KeyS: () => void attempt(connection.ask('cpu.switch', { position: 'STOP' })),
  KeyP: togglePause,
  KeyN: () => void attempt(connection.ask('time.step', { cycles: 1 })),
};

function startSearch(): void {
  searching.wanted = true;
  if (route.view !== 'program') go('program');
}

export function togglePause(): void {
  const mode = plc.pace.mode === 'pause' ? 'real' : 'pause';
  void attempt(connection.ask('time.pace', { mode, factor: plc.pace.factor }));
}

/** What a key does on the whole page; undefined leaves it to the element that has the focus. */
export function shortcut(
  event: Pick<KeyboardEvent, 'key' | 'code' | 'altKey' | 'ctrlKey' | 'shiftKey' | 'metaKey'>,
): Action | undefined {
  if (event.key === 'F1') return { kind: 'help' };
  if (event.ctrlKey && event.shiftKey && !event.altKey && event.code === 'KeyF')
    return { kind: 'run', run: startSearch };
  if (!event.altKey || event.ctrlKey || event.metaKey) return undefined;
  const digit = /^Digit(\d)$/.exec(event.code);
  if (digit) return { kind: 'view', number: (Number(digit[1]) + 9) % 10 };
  const run = runs[event.code];
  return run && { kind: 'run', run };
}
