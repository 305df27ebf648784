// The values of the operands in the lines that can be read, as long as they are wanted.
import { untrack } from 'svelte';
import { kept } from '../state/kept.svelte';
import { WatchList } from '../state/watch.svelte';
import { operandKey, operandsIn } from './nearby';
import type { OperandValues } from './operand_values';
import { workspace } from './workspace.svelte';

const MOST = 200;
const isBlock = (symbol: string): boolean =>
  /^(OB|FB|FC|DB|SFB|SFC|UDT)\b/i.test(workspace.symbols.ofName(symbol)?.operand ?? '');

export class SightedValues {
  private readonly watch = new WatchList(100);
  private lines = $state.raw<string[]>([]);
  private readonly shown: () => boolean;
  /** Whether people want to see them; this browser remembers it. */
  readonly beside = kept('program.besideOperand', false);

  /** In a component: `wanted` says whether they are shown now. */
  constructor(wanted: () => boolean) {
    this.shown = () => this.beside.value && wanted();
    const operands = $derived(this.shown() ? operandsIn(this.lines, isBlock).slice(0, MOST) : []);
    const key = $derived(operands.join('\n'));
    $effect(() => {
      void key;
      untrack(() => this.watch.set(operands.map((operand) => ({ operand }))));
    });
    $effect(() => () => this.watch.drop());
  }

  sight(lines: string[]): void {
    this.lines = lines;
  }

  /** Local variables have none: they are those of a call. */
  get values(): OperandValues {
    if (!this.shown()) return null;
    const known = this.watch.items.filter((item) => !item.problem && item.raw !== null);
    return new Map(known.map((item) => [operandKey(item.operand), item.text]));
  }
}
