// Cut, copy, paste and move: the clipboard holds AWL, an element as its statements, a network with its title and comment.
import { connection } from '../connection';
import { translator } from '../i18n';
import { networks as texts } from '../i18n/texts/networks';
import { attempt, messages } from '../state/messages.svelte';
import type { Editing } from './editing.svelte';
import { OWN, type Item } from './items';
import type { Change } from './keys';

const t = translator(texts);

/** What is being dragged: `number` of its network; null: the network itself. */
export interface Dragged {
  number: number;
  item: Item | null;
}

/** An operand at a pin is text of its box. */
export const isElement = (item: Item): boolean =>
  item.kind === 'contact' || item.kind === 'coil' || item.kind === 'frame' || (item.pin === OWN && !item.of);

let kept = '';
let isCopying = false;

/** Empty: it was refused. */
async function linesOf(editing: Editing, item: Item | null): Promise<string> {
  const { document, block } = editing.props;
  const { node, first } = item ?? {};
  const answer = await attempt(
    connection.ask('networks.copy', {
      file: document.path,
      text: document.text,
      line: block?.line ?? 1,
      network: editing.chosen,
      ...(node !== undefined && first !== undefined ? { elements: [{ node, first }] } : {}),
      language: editing.language,
    }),
  );
  return answer ? `${answer.lines.join('\n')}\n` : '';
}

/** `cut`: it is deleted, when it is in the clipboard. */
export async function copy(editing: Editing, cut: boolean): Promise<void> {
  const item = editing.current;
  if (!editing.picture || (item && !isElement(item)))
    return messages.problem({ text: t('notCopied') }, 'networks.copy');
  isCopying = true;
  await editing.turn.take(async () => {
    const text = await linesOf(editing, item);
    if (text === '') return;
    kept = text;
    // A page from another machine without TLS has no clipboard: there it is only the page's own.
    await navigator.clipboard?.writeText(text).catch(() => {});
    if (cut) await editing.ask({ action: item ? 'delete' : 'deleteNetwork' }, item, false);
  });
  isCopying = false;
}

/** Behind the selection, at the heading before the first element; what is on its way into the clipboard is waited for. */
export function paste(editing: Editing, event: ClipboardEvent): void {
  const given = event.clipboardData?.getData('text/plain') ?? '';
  const own = isCopying || !navigator.clipboard;
  event.preventDefault();
  editing.turn.whenFree(() => {
    const text = own ? kept : given;
    if (text.trim() === '' || editing.props.document.readonly) return;
    const first = /^\s*(NETWORK|NETZWERK|SEGMENT)/i.test(text) ? undefined : editing.first();
    if (first) void editing.edit({ action: 'paste', text, place: 'before' }, first);
    else void editing.edit({ action: 'paste', text, place: 'behind' }, editing.current);
  });
}

/** `item` of network `number`: behind what it is dropped on. */
export function move(editing: Editing, { number, item }: Dragged, at: Item | null): void {
  const { node, first } = item ?? {};
  const from = node !== undefined && first !== undefined ? { network: number, node, first } : { network: number };
  const change: Change = { action: 'move', from, place: 'behind' };
  void editing.edit(change, at);
}
