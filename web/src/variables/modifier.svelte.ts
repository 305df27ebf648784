import { connection, type Kept } from '../connection';
import { attempt, messages } from '../state/messages.svelte';
import { beyond, typeOf } from '../state/number_range';
import { refuse } from '../state/refuse';
import type { Point, Trigger } from './triggers';

interface Wish {
  operand: string;
  format: string;
  value: string;
}

const LIST = 1;

/** Modifies at once, or at a trigger point as long as it is wanted. */
export class Modifier {
  /** Where it modifies; null: nowhere. */
  point = $state<Point | null>(null);
  private kept: Kept<'modify.set'> | null = null;
  private readonly forget: () => void;

  constructor(private readonly onmodified: () => void) {
    this.forget = connection.on('modified', (message) => message.list === LIST && this.done());
  }

  modify(items: Wish[], { point, once }: Trigger): void {
    this.stop();
    const refused = items.flatMap((one) => beyond({ ...one, type: typeOf(one.operand, one.format) }));
    if (refused.length > 0) return refuse(refused);
    if (point === 'now') return void attempt(connection.ask('variables.write', { items }));
    this.point = point;
    const fields = { list: LIST, items, point, once };
    this.kept = connection.keep('modify.set', fields, undefined, 'modify.drop', { list: LIST }, (problems) => {
      messages.problems(problems);
      this.stop();
    });
  }

  stop(): void {
    this.kept?.drop();
    this.kept = null;
    this.point = null;
  }

  destroy(): void {
    this.stop();
    this.forget();
  }

  private done(): void {
    this.stop();
    this.onmodified();
  }
}
