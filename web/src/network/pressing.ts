// What a key does in the networks: walk, command, edit.
import { translator } from '../i18n';
import { networks as texts } from '../i18n/texts/networks';
import { messages } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';
import { copy } from './clipboard';
import type { Editing } from './editing.svelte';
import { changeOf, directionOf, isTyped, typedInto, type Key } from './keys';

const t = translator(texts);

/** False: a key of somebody else. `target`: where it was pressed; null: it waited for an edit. */
export function press(editing: Editing, key: Key, target: Element | null, onpalette: () => void): boolean {
  if (editing.field) return typed(editing, key);
  if (editing.turn.unheard(key)) return true;
  if (key.key === 'F8' && plc.breakpoint) return false;
  const button = target?.closest('button');
  if (button && key.key === 'Enter' && !button.matches('[data-head]')) return false;
  return moves(editing, key) || commands(editing, key, onpalette) || edits(editing, key);
}

/** A key that came while the operand field was on its way. */
function typed(editing: Editing, key: Key): boolean {
  const { field } = editing;
  if (!field) return false;
  if (key.key === 'Enter') editing.finish(field.text, true);
  else if (key.key === 'Escape') editing.close();
  else editing.field = { ...field, text: typedInto(field.text === field.item.operand ? '' : field.text, key) };
  return true;
}

function moves(editing: Editing, key: Key): boolean {
  const direction = directionOf(key);
  if (direction) return (editing.walk(direction), true);
  if (key.ctrl || key.alt || (key.key !== 'Home' && key.key !== 'End')) return false;
  editing.toEnd(key.key === 'Home');
  return true;
}

/** The browser copies and pastes what is selected as text. */
const isText = (): boolean => !(window.getSelection()?.isCollapsed ?? true);

const commandKeys: Record<string, (editing: Editing) => void> = {
  s: ({ props }) => props.onsave(),
  l: ({ props }) => props.onload(),
  z: (editing) => editing.undo(false),
  y: (editing) => editing.undo(true),
  Z: (editing) => editing.undo(true),
  c: (editing) => void copy(editing, false),
  x: (editing) => void copy(editing, true),
  r: (editing) => void editing.edit({ action: 'newNetwork' }, null),
  Delete: (editing) => void editing.edit({ action: 'deleteNetwork' }, null),
};

function commands(editing: Editing, key: Key, onpalette: () => void): boolean {
  if (key.ctrl && key.key === 'c' && isText()) return false;
  const command = key.ctrl && !key.alt && !editing.props.document.readonly ? commandKeys[key.key] : undefined;
  if (command) command(editing);
  else if (key.alt && key.key === 'F9') onpalette();
  else return false;
  return true;
}

/** A text without a place says so: nothing that is typed is lost unseen. */
function typedAt(editing: Editing, key: Key): void {
  if (editing.type(key.key)) return;
  messages.problem({ text: t('noOperand') }, 'networks.edit');
  editing.turn.deaf = true;
}

function edits(editing: Editing, key: Key): boolean {
  const item = editing.current;
  const { view, document } = editing.props;
  if (document.readonly || !editing.picture) return false;
  if (key.key === 'Enter') return editing.type();
  if (isTyped(key)) return (typedAt(editing, key), true);
  const change = changeOf(key, view);
  if (!change) return false;
  // A network is deleted at its head, with Ctrl; what is in it, by its elements.
  if (change.action === 'delete' && !item) return false;
  const first = /^CONTACT/.test(change.element ?? '') ? editing.first() : undefined;
  if (first) void editing.edit({ ...change, place: 'before' }, first);
  else void editing.edit(change, item);
  return true;
}
