import { connection, type Events, type FieldsOf, type Kept, type Problem } from '../connection';

import type { WatchedItem } from '../connection/protocol';

/** Where in the cycle values are looked at; "now": whenever there is something to tell. */
export interface WatchTrigger {
  point: NonNullable<FieldsOf<'watch.set'>['point']>;
  once: boolean;
}

export interface WatchItem {
  operand: string;
  format?: string;
}

export interface Watched {
  /** As the item named it. */
  operand: string;
  /** As the server calls it: "A 1.0" for "Motor". */
  address: string;
  symbol: string;
  comment: string;
  type: string;
  bits: number;
  format: string;
  problem?: Problem;
  /** As the server prints it in the item's format; "?" while unknown. */
  text: string;
  /** The value as a number: unsigned bits, REAL as a number; null while unknown. */
  raw: number | null;
  /** Whether the server has sent it. */
  sent?: boolean;
}

const lists = new Map<number, WatchList>();
let nextList = 1;
connection.on('values', (message) => lists.get(message.list)?.receive(message));

/** Values of operands that the server keeps up to date. `set` may be called at any time; `drop` when the view goes. */
export class WatchList {
  /** One entry per item, in the order of the items. */
  items = $state<Watched[]>([]);
  private readonly list = nextList++;
  private kept: Kept<'watch.set'> | null = null;
  /** The server has answered what is wanted now: what comes before that are values of the items of before. */
  private answered = false;

  constructor(private readonly everyMs = 33) {
    lists.set(this.list, this);
  }

  set(items: WatchItem[], { point, once }: WatchTrigger = { point: 'now', once: false }): void {
    const wanted = items.map(({ operand, format }) => ({ operand, format: format ?? 'AUTO' }));
    const known = new Map(this.items.map((item) => [item.operand, item]));
    this.items = wanted.map((item): Watched => {
      const before = known.get(item.operand);
      return before ? { ...before, format: item.format } : unknown(item);
    });
    this.answered = false;
    const fields = { list: this.list, items: wanted, everyMs: this.everyMs, point, once };
    if (this.kept) this.kept.update(fields);
    else
      this.kept = connection.keep(
        'watch.set',
        fields,
        (result) => this.described(result),
        'watch.drop',
        { list: this.list },
        (problems) => this.refused(problems),
      );
  }

  /** Whether the server has said of each item what it is. */
  get complete(): boolean {
    return this.items.every((item) => item.sent || item.problem);
  }

  drop(): void {
    this.kept?.drop();
    this.kept = null;
    lists.delete(this.list);
  }

  receive(message: Events['values']): void {
    if (!this.answered) return;
    for (const [index, text, raw] of message.values) {
      const item = this.items[index];
      if (!item) continue;
      item.text = text;
      item.raw = raw;
      item.sent = true;
    }
  }

  /** Nothing of it is looked at: the rows say why. */
  private refused([problem]: Problem[]): void {
    this.answered = false;
    for (const item of this.items) Object.assign(item, { problem, text: '?', raw: null, sent: false });
  }

  private described(result: { items: WatchedItem[] }): void {
    this.answered = true;
    result.items.forEach((described, index) => {
      const item = this.items[index];
      if (!item) return;
      const { operand, ...rest } = described;
      Object.assign(item, { problem: undefined, address: operand ?? '' }, rest);
    });
  }
}

function unknown(item: { operand: string; format: string }): Watched {
  return { ...item, address: '', symbol: '', comment: '', type: '', bits: 0, text: '?', raw: null };
}
