// What the view of the networks gets from the program view, and what it tells it.
import type { OpenDocument } from '../editor/document.svelte';
import type { BlockOutline } from '../editor/outline';
import type { StatusRow } from '../editor/status_columns';
import type { Display } from '../editor/symbolic';
import type { View } from './networks.svelte';

export interface NetworkViewProps {
  document: OpenDocument;
  block: BlockOutline | undefined;
  /** Of the cursor in the text. */
  line: number;
  view: Exclude<View, 'awl'>;
  display: Display;
  /** null: no status is shown. */
  rows: readonly StatusRow[] | null;
  halt: number | null;
  /** The line of the statement that stopped the CPU. */
  failed: number | null;
  points: readonly number[];
  ongoto: (line: number) => void;
  ontext: (line: number) => void;
  onedit: (from: number, to: number, lines: string[]) => void;
  onundo: (again: boolean) => void;
  onsave: () => void;
  onload: () => void;
  onbreakpoint: (line: number) => void;
}
