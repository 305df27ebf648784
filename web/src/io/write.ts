import { connection } from '../connection';
import { attempt } from '../state/messages.svelte';

/** Writes one operand as a user typed it; problems are shown. True if the CPU took it. */
export async function writeValue(operand: string, value: string, format: string): Promise<boolean> {
  const answer = connection.ask('variables.write', { items: [{ operand, value, format }] });
  return (await attempt(answer)) !== undefined;
}
