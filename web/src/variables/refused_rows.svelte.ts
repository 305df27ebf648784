// Rows whose modify value was refused: marked until what is typed in them changes, and told by row and operand.
import { SvelteMap } from 'svelte/reactivity';
import { translator } from '../i18n';
import { variables } from '../i18n/texts/variables';
import { messages } from '../state/messages.svelte';
import type { Refusal, Wish } from './modifier.svelte';
import type { Row } from './table';

const t = translator(variables);
/** So many rows have a message of their own. */
const NAMED = 3;

export interface RowWish extends Wish {
  row: Row;
  number: number;
}

export class RefusedRows {
  private readonly rows = new SvelteMap<Row, { typed: string; reason: string }>();

  /** Empty: nothing was refused, or it has been changed since. */
  reasonOf(row: Row): string {
    const found = this.rows.get(row);
    return found?.typed === typedIn(row) ? found.reason : '';
  }

  /** These are tried again. */
  forget(wishes: readonly RowWish[]): void {
    for (const { row } of wishes) this.rows.delete(row);
  }

  /** `method`: what refused them; its next success takes the messages away. */
  tell(refused: readonly Refusal<RowWish>[], method: string): void {
    messages.solved(method);
    for (const { wish, reason } of refused) this.rows.set(wish.row, { typed: typedIn(wish.row), reason });
    const all = refused.length <= NAMED;
    for (const { wish, reason } of refused.slice(0, all ? NAMED : NAMED - 1))
      messages.problem({ text: t('notModified', { row: wish.number, operand: wish.operand, reason }) }, method);
    if (!all) messages.problem({ text: t('moreNotModified', { count: refused.length - NAMED + 1 }) }, method);
  }
}

const typedIn = ({ operand, format, modify }: Row): string => JSON.stringify([operand, format, modify]);
