import { connection, Refused, type Kept } from '../connection';
import type { RefusedItem } from '../connection/protocol';
import { told } from '../i18n';
import { attempt, messages } from '../state/messages.svelte';
import { beyond, typeOf } from '../state/number_range';
import { beyondText } from '../state/refuse';
import type { Point, Trigger } from './triggers';

export interface Wish {
  operand: string;
  format: string;
  value: string;
}

export interface Refusal<W extends Wish> {
  wish: W;
  reason: string;
}

const LIST = 1;
const plain = ({ operand, format, value }: Wish): Wish => ({ operand, format, value });

/** Modifies at once, or at a trigger point as long as it is wanted: each value by itself. */
export class Modifier<W extends Wish> {
  /** Where it modifies; null: nowhere. */
  point = $state<Point | null>(null);
  private kept: Kept<'modify.set'> | null = null;
  private readonly forget: () => void;

  constructor(
    private readonly onmodified: () => void,
    /** These were left out; the others are written. `method`: what refused them. */
    private readonly onrefused: (refused: Refusal<W>[], method: string) => void,
  ) {
    this.forget = connection.on('modified', (message) => message.list === LIST && this.done());
  }

  /** All of them. */
  modify(wishes: W[], trigger: Trigger): void {
    this.stop();
    if (trigger.point === 'now') void this.write(wishes);
    else this.keep(wishes, trigger as Trigger & { point: Exclude<Point, 'now'> });
  }

  /** At once; what goes on at a trigger point goes on. */
  async write(wishes: W[]): Promise<void> {
    const { good, tooLarge } = sorted(wishes);
    const items = good.map(plain);
    const answer =
      items.length > 0 ? await attempt(connection.ask('variables.write', { items, each: true })) : { refused: [] };
    this.tell([...tooLarge, ...named(good, answer?.refused ?? [])], 'variables.write');
  }

  async force(wish: W): Promise<void> {
    try {
      await connection.ask('variables.force', { items: [plain(wish)] });
    } catch (error) {
      if (!(error instanceof Refused)) return;
      this.tell([{ wish, reason: told(error.problems[0]!) }], 'variables.force');
    }
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

  private keep(wishes: W[], { point, once }: Trigger & { point: Exclude<Point, 'now'> }): void {
    const { good, tooLarge } = sorted(wishes);
    this.tell(tooLarge, 'modify.set');
    if (good.length === 0) return;
    this.point = point;
    const fields = { list: LIST, items: good.map(plain), point, once, each: true };
    this.kept = connection.keep(
      'modify.set',
      fields,
      ({ refused }) => this.tell(named(good, refused), 'modify.set'),
      'modify.drop',
      { list: LIST },
      (problems) => {
        messages.problems(problems);
        this.stop();
      },
    );
  }

  private tell(refused: Refusal<W>[], method: string): void {
    if (refused.length > 0) this.onrefused(refused, method);
  }

  private done(): void {
    this.stop();
    this.onmodified();
  }
}

/** What the page knows to be too large is not sent. */
function sorted<W extends Wish>(wishes: W[]): { good: W[]; tooLarge: Refusal<W>[] } {
  const found = wishes.map((wish) => ({
    wish,
    beyond: beyond({ ...wish, type: typeOf(wish.operand, wish.format) })[0],
  }));
  return {
    good: found.filter((one) => !one.beyond).map(({ wish }) => wish),
    tooLarge: found.flatMap(({ wish, beyond }) => (beyond ? [{ wish, reason: beyondText(beyond) }] : [])),
  };
}

const named = <W extends Wish>(wishes: W[], refused: RefusedItem[]): Refusal<W>[] =>
  refused.map(({ item, problem }) => ({ wish: wishes[item]!, reason: told(problem) }));
