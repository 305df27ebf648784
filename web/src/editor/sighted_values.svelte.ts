// The values of the operands in the lines that can be read, as long as they are wanted.
import { untrack } from 'svelte';
import { kept } from '../state/kept.svelte';
import { WatchList } from '../state/watch.svelte';
import { isQueryOfTimer, operandKey, operandsIn } from './nearby';
import type { LocalValues } from './local_values';
import type { OperandValues } from './operand_values';
import { workspace } from './workspace.svelte';

const MOST = 200;
/** Local variables are those of a call: the program status has seen them, nobody can read them. */
const isGlobal = (operand: string): boolean => !operand.startsWith('#');
const isNoValue = (symbol: string): boolean =>
  /^(OB|FB|FC|DB|SFB|SFC|UDT)\b/i.test(workspace.symbols.ofName(symbol)?.operand ?? '');

export class SightedValues {
  private readonly watch = new WatchList(100);
  private lines = $state.raw<string[]>([]);
  private readonly shown: () => boolean;
  /** Whether people want to see them; this browser remembers it. */
  readonly beside = kept('program.besideOperand', false);

  /** In a component: `wanted` says whether they are shown now; `locals`: what the program status has seen. */
  constructor(
    wanted: () => boolean,
    private readonly locals: () => LocalValues,
  ) {
    this.shown = () => this.beside.value && wanted();
    const operands = $derived(this.shown() ? operandsIn(this.lines, isNoValue).filter(isGlobal).slice(0, MOST) : []);
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

  get values(): OperandValues {
    if (!this.shown()) return null;
    const known = this.watch.items.filter((item) => !item.problem && item.raw !== null);
    const values = new Map(known.map((item) => [operandKey(item.operand), item.text]));
    const locals = this.locals();
    const operandOf = (written: string) => workspace.symbols.ofName(written.replace(/"/g, ''))?.operand ?? written;
    return (written, line, text) => {
      if (/^[#=]/.test(written)) return locals.get(line)?.get(operandKey(written));
      return isQueryOfTimer(text, operandOf(written)) ? undefined : values.get(operandKey(written));
    };
  }
}
