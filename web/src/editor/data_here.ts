import type { Side } from './workspace.svelte';

interface Coded {
  block: string;
  side: Side;
}

/** The data block whose table is shown in place of the text: one of the CPU always, one of a source (`here`) if it is wanted. */
export function dataShown(code: Coded | null | undefined, wanted: boolean, here: string): Coded | null {
  if (code) return /^DB \d/.test(code.block) ? code : null;
  return wanted && here ? { block: here, side: 'offline' } : null;
}
