// The keys of STEP 7's ladder and function block editors, as edits at the selected place.
import type { FieldsOf } from '../connection';
import type { Requests } from '../connection/protocol';
import { OWN, type Direction, type Item } from './items';
import type { View } from './networks.svelte';

export type Edit = FieldsOf<'networks.edit'>['edit'];
export type Edited = Requests['networks.edit']['result'];
/** An edit without its place. */
export type Change = Omit<Edit, 'node' | 'pin' | 'first'>;

export interface Key {
  key: string;
  ctrl: boolean;
  alt: boolean;
  shift: boolean;
}

export const keyOf = (event: KeyboardEvent): Key => ({
  key: event.key,
  ctrl: event.ctrlKey || event.metaKey,
  alt: event.altKey,
  shift: event.shiftKey,
});

const insert = (element: string, place: Change['place'] = 'behind'): Change => ({ action: 'insert', element, place });

interface KeyRow {
  key: string;
  kop: Change;
  fup: Change;
}

/** F2 to F9 as in STEP 7; what a key does in FUP differs. */
export const keyRows: readonly KeyRow[] = [
  { key: 'F2', kop: insert('CONTACT'), fup: insert('AND') },
  { key: 'F3', kop: insert('CONTACT_NOT'), fup: insert('OR') },
  { key: 'F7', kop: insert('COIL'), fup: insert('COIL') },
  { key: 'F8', kop: insert('CONTACT', 'parallel'), fup: { action: 'addInput' } },
  { key: 'F9', kop: { action: 'closeBranch' }, fup: { action: 'negate' } },
];

/** At a pin that is open, an element is put there. */
export function placed(change: Change, item: Item | null): Change {
  const atPin = item !== null && item.kind === 'field' && item.pin !== OWN;
  return change.action === 'insert' && change.place === 'behind' && atPin ? { ...change, place: 'atPin' } : change;
}

/** What a key changes; undefined: nothing. */
export function changeOf(key: Key, view: View): Change | undefined {
  if (key.ctrl || key.alt) return undefined;
  if (key.key === 'Delete' || key.key === 'Backspace') return { action: 'delete' };
  const row = keyRows.find((one) => one.key === key.key);
  return row && (view === 'fup' ? row.fup : row.kop);
}

const directions: Record<string, Direction> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
};
export const directionOf = (key: Key): Direction | undefined => (key.ctrl || key.alt ? undefined : directions[key.key]);

/** `text` with the key typed behind it. */
export function typedInto(text: string, key: Key): string {
  if (key.key === 'Backspace') return text.slice(0, -1);
  return key.key.length === 1 && !key.ctrl ? text + key.key : text;
}

/** Nothing by itself, or the way out. */
export const isModifier = (key: Key): boolean => /^(Shift|Control|Alt|AltGraph|Meta|CapsLock|Tab)$/.test(key.key);

/** A character that begins an operand. */
export const isTyped = (key: Key): boolean => key.key.length === 1 && key.key !== ' ' && !key.ctrl && !key.alt;
