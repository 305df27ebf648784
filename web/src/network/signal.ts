// What the program status says of a wire or a value (S7-EDIT-21): bits of real statements, never a second calculation.
import type { NetworkPicture, NetworkShape } from '../connection/protocol';
import type { StatusRow } from '../editor/status_columns';
import { formOf, type ValueType } from './value_form';

/** The last status row of each line. */
export type StatusLines = ReadonlyMap<number, StatusRow>;

export type Signal = 'on' | 'off' | 'unknown';

export const linesOf = (rows: readonly StatusRow[] | null): StatusLines | null =>
  rows && new Map(rows.map((row) => [row[0], row]));

const VKE = 1;
const STA = 2;
const AKKU1 = 4;
const OF_CALL = 11;

type Flow = NonNullable<NetworkShape['flow']>;

/**
 * Whether any of it has been processed: only then there is power at its rail. A CALL without logic has no wire that names a
 * statement, but a box that does.
 */
export const isProcessed = (picture: Pick<NetworkPicture, 'line' | 'shapes'>, lines: StatusLines | null): boolean =>
  lines !== null &&
  picture.shapes.some(({ flow = [], line }) =>
    [...flow.map(([at]) => at), line].some((at) => at !== undefined && lines.has(picture.line + at)),
  );

/** All have to be 1; one that was not processed leaves the wire without a colour. `first`: line of the network. */
export function signalOf(flow: Flow | undefined, lines: StatusLines | null, first: number): Signal {
  if (!lines || !flow) return 'unknown';
  let on = true;
  for (const [line, bit] of flow) {
    const row = lines.get(first + line);
    if (!row) return 'unknown';
    const is = String(row[bit === 'vke' ? VKE : STA]) === '1';
    if (is === (bit === 'notSta')) on = false;
  }
  return on ? 'on' : 'off';
}

/** What the operand of a CALL held, as the server writes it. */
export function givenAt(line: number, parameter: string, lines: StatusLines | null): string {
  const values = lines?.get(line)?.[OF_CALL];
  return typeof values === 'object' ? (values[parameter] ?? '') : '';
}

/** AKKU 1 behind the statement that loads or transfers the operand. */
export function valueAt(line: number, type: ValueType, lines: StatusLines | null): string {
  const bits = Number.parseInt(String(lines?.get(line)?.[AKKU1]), 16);
  return Number.isNaN(bits) ? '' : formOf(bits, type);
}
