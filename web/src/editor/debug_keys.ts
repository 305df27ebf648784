// The keys of a program that stands at a breakpoint.
import { connection } from '../connection';
import { attempt } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';

/** False: a key of somebody else. */
export function debugKey(event: KeyboardEvent): boolean {
  if (!plc.breakpoint || event.altKey) return false;
  const keys: Record<string, () => Promise<unknown>> = {
    F8: () => connection.ask('debug.go'),
    F10: () => connection.ask('debug.step', { kind: 'over' }),
    F11: () => connection.ask('debug.step', { kind: event.shiftKey ? 'out' : 'into' }),
  };
  const ask = keys[event.key];
  if (ask) void attempt(ask());
  return ask !== undefined;
}
