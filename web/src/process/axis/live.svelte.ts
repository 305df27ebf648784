// The instance data block of the axis: its values as they are, and writing them.
import { connection } from '../../connection';
import { attempt } from '../../state/messages.svelte';
import { WatchList } from '../../state/watch.svelte';

const BOTH = [
  ['DRV_EN', 'START', 'DIR_P', 'DIR_M', 'STOP', 'ERR_A', 'MODE_IN', 'TARGET', 'SPEED'],
  ['WORKING', 'POS_RCD', 'SYNC', 'ACT_POS', 'MODE_OUT', 'ERR', 'ST_ENBLD', 'ERROR', 'STATUS'],
  [
    'CHGDIFF_P',
    'CUTOFFDIFF_P',
    'CHGDIFF_M',
    'CUTOFFDIFF_M',
    'PARA',
    'DIR',
    'CUTOFF',
    'CHGOVER',
    'DIST_TO_GO',
    'LAST_TRG',
  ],
  ['JOB_REQ', 'JOB_DONE', 'JOB_ERR', 'JOB_ID', 'JOB_STAT', 'JOB_VAL'],
].flat();
const ANALOG = ['ACCEL', 'DECEL'];

/** Signed numbers come as bits. */
const INTEGERS = new Set(['MODE_IN', 'MODE_OUT', 'JOB_ID']);
const LONG = new Set([
  ...['TARGET', 'SPEED', 'ACT_POS', 'ACCEL', 'DECEL', 'JOB_VAL', 'DIST_TO_GO', 'LAST_TRG'],
  ...['CHGDIFF_P', 'CUTOFFDIFF_P', 'CHGDIFF_M', 'CUTOFFDIFF_M'],
]);

export function signed(name: string, raw: number, bits = LONG.has(name) ? 32 : INTEGERS.has(name) ? 16 : 0): number {
  return bits && raw >= 2 ** (bits - 1) ? raw - 2 ** bits : raw;
}

/** As AWL writes them. */
export function literal(name: string, value: number | boolean, digital: boolean): string {
  if (typeof value === 'boolean') return value ? '1' : '0';
  return LONG.has(name) && !(digital && name === 'SPEED') ? `L#${value}` : String(value);
}

export class AxisBlock {
  private watch = new WatchList(50);
  private block = '';
  private digital = false;

  follow(block: string, digital: boolean): void {
    if (block === this.block && digital === this.digital) return;
    this.block = block;
    this.digital = digital;
    const names = block ? [...BOTH, ...(digital ? [] : ANALOG)] : [];
    this.watch.set(names.map((name) => ({ operand: this.operand(name) })));
  }

  drop(): void {
    this.watch.drop();
  }

  operand(name: string): string {
    return `${this.block.replace(' ', '')}.${name}`;
  }

  /** Undefined while unknown. */
  value(name: string): number | undefined {
    const item = this.watch.items.find((one) => one.operand === this.operand(name));
    if (!item || item.raw === null) return undefined;
    return this.digital && name === 'SPEED' ? item.raw : signed(name, item.raw);
  }

  /** `held`: bits that are 1 as long as somebody holds them; the server lets go when this page is gone. */
  async write(values: Record<string, number | boolean>, held = false): Promise<void> {
    const items = Object.entries(values).map(([name, value]) => ({
      operand: this.operand(name),
      value: literal(name, value, this.digital),
    }));
    await attempt(connection.ask('variables.write', { items, held }));
  }

  /** A positive edge: the block sees 0 in a call before and 1 in one behind, however short the cycle is. */
  async pulse(name: string, beside: Record<string, number | boolean> = {}): Promise<void> {
    await this.write({ ...beside, [name]: false });
    await pause();
    await this.write({ [name]: true }, true);
    await pause();
    await this.write({ [name]: false });
  }
}

/** Longer than the cycle of any program that is operated by hand. */
const pause = () => new Promise<void>((done) => setTimeout(done, 200));
