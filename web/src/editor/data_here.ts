import type { Side } from './workspace.svelte';

interface Coded {
  block: string;
  side: Side;
}

/**
 * The data block whose table is shown in place of the text: one of the CPU always, one of a source if it is `wanted`, the text is there
 * (`here`), and somebody has opened it: a cursor that comes into it by keys or with a selection stays in the text.
 */
export function dataShown(code: Coded | null | undefined, wanted: boolean, here: string, opened: string): Coded | null {
  if (code) return /^DB \d/.test(code.block) ? code : null;
  return wanted && here && here === opened ? { block: here, side: 'offline' } : null;
}
