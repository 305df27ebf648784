// Breakpoints of a file: all of them are set anew.
import { connection } from '../connection';
import { attempt } from '../state/messages.svelte';
import type { OpenDocument } from './document.svelte';

export function setBreakpoints(document: OpenDocument | null, lines: number[]): void {
  if (document && !document.readonly) void attempt(connection.ask('breakpoints.set', { file: document.path, lines }));
}

export const toggled = (lines: readonly number[], line: number): number[] =>
  lines.includes(line) ? lines.filter((one) => one !== line) : [...lines, line];
