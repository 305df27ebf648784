// What the program status says of a wire or a value (S7-EDIT-21): bits of real statements, never a second calculation.
import type { NetworkPicture, NetworkShape } from '../connection/protocol';
import type { StatusRow } from '../editor/status_columns';

/** The last status row of each line. */
export type StatusLines = ReadonlyMap<number, StatusRow>;

export type Signal = 'on' | 'off' | 'unknown';

export const linesOf = (rows: readonly StatusRow[] | null): StatusLines | null =>
  rows && new Map(rows.map((row) => [row[0], row]));

const VKE = 1;
const STA = 2;
const AKKU1 = 4;

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

const real = (bits: number): string => {
  const view = new DataView(new ArrayBuffer(4));
  view.setUint32(0, bits);
  return Number(view.getFloat32(0).toPrecision(6)).toString();
};

/** As LC gives it: three digits, of a timer with its base above them. */
function bcdOf(bits: number, title: string): string {
  const digits = Number.parseInt((bits & 0xfff).toString(16), 10);
  if (!/^S_/.test(title)) return String(digits);
  const milliseconds = digits * 10 ** (((bits >> 12) & 3) + 1);
  return `S5T#${milliseconds / 1000}s`;
}

/** AKKU 1 behind the statement of a value, as the box reads it: `title` is "ADD_R", "CMP >D". */
export function valueAt(line: number, bcd: boolean, title: string, lines: StatusLines | null): string {
  const row = lines?.get(line);
  if (!row) return '';
  const bits = Number.parseInt(String(row[AKKU1]), 16);
  if (Number.isNaN(bits)) return '';
  if (bcd) return bcdOf(bits, title);
  if (/(_R|[<>=]R|R)$/.test(title)) return real(bits);
  if (/D?(DI|[<>=]D|_D)$/.test(title)) return String(bits | 0);
  if (/(I|[<>=]I)$/.test(title)) return String((bits << 16) >> 16);
  return bits > 0xffff ? `16#${bits.toString(16).toUpperCase()}` : String(bits);
}
