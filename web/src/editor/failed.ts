// The statement that stopped the CPU, with the registers of that instant, from the interrupt stack.
import type { InterruptLevel } from '../connection/protocol';
import { statusColumns, type StatusRow } from './status_columns';

export interface Failed {
  block: string;
  file: string;
  line: number;
  registers: Record<string, string>;
}

/** The level that was interrupted last; without a line in a source there is nothing to mark. */
export function failedOf(interrupts: readonly InterruptLevel[]): Failed | null {
  const { block, file, line, registers } = interrupts[0] ?? {};
  return block && file && line && registers ? { block, file, line, registers } : null;
}

/** Bits of the status word, from the lowest on. */
const bits: Record<string, number> = { vke: 1, sta: 2, or: 3 };
const ofRegister: Record<string, string> = {
  akku1: 'AKKU1',
  akku2: 'AKKU2',
  ar1: 'AR1',
  ar2: 'AR2',
  stw: 'STW',
  db: 'DB',
  di: 'DI',
};

/** What the columns of the program status say of it. */
export function statusOf({ line, registers }: Failed): StatusRow {
  const word = Number.parseInt(registers['STW'] ?? '', 16);
  const text = (id: string): string => {
    const bit = bits[id];
    if (bit === undefined) return (registers[ofRegister[id] ?? ''] ?? '').replace(/^-$/, '');
    return Number.isNaN(word) ? '' : String((word >> bit) & 1);
  };
  return [line, ...statusColumns.map(({ id }) => text(id))];
}

/** The rest of the program status is of the cycles before: beside the statement stands what it found. */
export const withFailed = (rows: readonly StatusRow[] | null, failed: Failed | null): readonly StatusRow[] | null =>
  failed ? [...(rows ?? []).filter(([line]) => line !== failed.line), statusOf(failed)] : rows;

/** Whether it stands in this block, which then needs no word about a status that it has not. */
export const isIn = (block: { line: number; end: number } | undefined, failed: Failed | null): boolean =>
  failed !== null && block !== undefined && block.line <= failed.line && failed.line <= block.end;
