// The keys that hold in the whole program view, wherever the keyboard is.
import type { View } from '../network/networks.svelte';
import { viewOf } from '../network/representation';
import { commandOf } from './commands';
import { debugKey } from './debug_keys';
import { paneKey } from './panes';

/** What is missing cannot be done now. */
interface ProgramActions {
  save: () => void;
  load: () => void;
  enter: (() => void) | undefined;
  show: ((view: View) => void) | undefined;
}

export function programKey(event: KeyboardEvent, actions: ProgramActions): void {
  const view = actions.show && viewOf(event);
  if (view) actions.show?.(view);
  else if (!paneKey(event) && !command(event, actions) && !debugKey(event)) return;
  event.preventDefault();
}

function command(event: KeyboardEvent, actions: ProgramActions): boolean {
  const wanted = event.defaultPrevented ? undefined : commandOf(event);
  const act = wanted && actions[wanted];
  act?.();
  return act !== undefined;
}
