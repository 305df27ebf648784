import { connection, type Events, type Kept } from '../connection';
import type { CurveItem } from '../connection/protocol';
import { isNumber, isText, listOf, objectOf } from '../state/alike';
import { keptByName } from '../state/kept.svelte';
import { append, type Columns, type Curve } from './curves';

const choices = keptByName<{ operands: string[]; everyMs: number }>(
  'trends',
  objectOf({ operands: listOf(isText), everyMs: isNumber }),
);

/** Curves being recorded: they go on while the view is closed, so that nothing is missed. */
class Recorder {
  curves = $state.raw<Curve[]>([]);
  columns = $state.raw<Columns>([[]]);
  everyMs = $state(100);
  private project = '';
  private subscription: Kept<'trend.set'> | null = null;
  /** The server has answered what is wanted now: samples before that are of the curves of before. */
  private answered = false;

  constructor() {
    connection.on('samples', (message) => this.receive(message));
  }

  /** The curves that this browser kept of the project. */
  follow(project: string): void {
    if (project === this.project) return;
    this.project = project;
    const choice = choices.value[project];
    this.everyMs = choice?.everyMs ?? 100;
    this.show((choice?.operands ?? []).map(unknown));
  }

  /** Undefined, or why one of them is no curve; then none is added. */
  async refused(operands: string[]): Promise<Curve['problem']> {
    const items = operands.filter(Boolean).map((operand) => ({ operand }));
    const answer = await connection.ask('trend.check', { items });
    return answer.items.find((item) => item.problem)?.problem;
  }

  add(operands: string[]): void {
    const there = new Set(this.curves.map((curve) => curve.operand));
    const fresh = operands.filter((operand) => operand && !there.has(operand));
    if (fresh.length) this.show([...this.curves, ...fresh.map(unknown)]);
  }

  remove(curve: Curve): void {
    this.show(this.curves.filter((one) => one !== curve));
  }

  sampleEvery(ms: number): void {
    this.everyMs = ms;
    this.show(this.curves);
  }

  clear(): void {
    this.columns = [[], ...this.curves.map(() => [])];
  }

  /** Old samples stay with the curves that stay; a new curve has none of before. */
  private show(curves: Curve[]): void {
    const [time, ...values] = this.columns;
    const column = (curve: Curve) =>
      values[this.curves.findIndex((one) => one.operand === curve.operand)] ?? time.map(() => null);
    this.columns = [time, ...curves.map(column)];
    this.curves = curves;
    choices.value = {
      ...choices.value,
      [this.project]: { operands: curves.map((curve) => curve.operand), everyMs: this.everyMs },
    };
    this.subscribe();
  }

  private subscribe(): void {
    const items = this.curves.map(({ operand }) => ({ operand }));
    const fields = { list: 1, items, everyMs: this.everyMs };
    this.answered = false;
    if (this.subscription) this.subscription.update(fields);
    else
      this.subscription = connection.keep(
        'trend.set',
        fields,
        (result) => this.described(result),
        'trend.drop',
        { list: 1 },
        ([problem]) => (this.curves = this.curves.map((curve) => ({ ...curve, problem }))),
      );
  }

  private described(result: { items: CurveItem[] }): void {
    if (result.items.length !== this.curves.length) return;
    this.answered = true;
    this.curves = this.curves.map((curve, index) => {
      const { operand: address, ...rest } = result.items[index]!;
      return { ...curve, problem: undefined, ...rest, address };
    });
  }

  private receive({ list, rows }: Events['samples']): void {
    if (list !== 1 || !this.answered || rows[0]?.length !== this.curves.length + 1) return;
    this.columns = append(this.columns, rows);
  }
}

function unknown(operand: string): Curve {
  return { operand, address: operand, symbol: '', unit: '', bits: 0 };
}

export const recorder = new Recorder();
