import type { Problem } from '../connection';
import { inNumbers, operandText } from '../i18n';

/** One curve as the server describes it. */
export interface Curve {
  /** As the user named it: "MW 10", "\"Motor\"", "plant.Belt.SPEED". */
  operand: string;
  /** As the PLC calls it. */
  address: string;
  symbol: string;
  unit: string;
  /** 1: a bit, drawn in a lane of its own. */
  bits: number;
  /** As the PLC declares it; none of a plant. */
  type?: string;
  problem?: Problem;
}

/** Columns: seconds of virtual time, then one per curve. */
export type Columns = [time: number[], ...values: (number | null)[][]];

/** What is kept in the browser: two hours at ten samples a second. */
export const MOST_ROWS = 72_000;

/** Rows `[timeMs, v0, v1, …]` behind what there is; from the beginning when time went back. */
export function append(columns: Columns, rows: (number | null)[][]): Columns {
  const first = rows[0]?.[0];
  const last = columns[0][columns[0].length - 1];
  const back = first != null && last !== undefined && first / 1000 < last;
  const next = columns.map((column) => (back ? [] : column.slice(-MOST_ROWS))) as Columns;
  for (const row of rows) {
    next[0].push(Number(row[0]) / 1000);
    for (let i = 1; i < next.length; ++i) next[i]!.push((row[i] ?? null) as never);
  }
  return next;
}

/** Bits lie in lanes below each other, the first on top: a lane is 1 high, the bit three quarters of it. */
export function laned(columns: Columns, curves: Curve[]): Columns {
  const bits = curves.filter((curve) => curve.bits === 1).length;
  let lane = bits;
  const values = columns.slice(1).map((column, index) => {
    if (curves[index]?.bits !== 1) return column;
    const floor = --lane + 0.125;
    return column.map((value) => (value === null ? null : floor + (value ? 0.75 : 0)));
  });
  return [columns[0], ...values] as Columns;
}

const plain = (name: string): string => name.replace(/[\s"]/g, '').toUpperCase();

/** What the user called it, and what it is called otherwise. */
export function namesOf({ operand, address, symbol }: Curve): { name: string; others: string[] } {
  const shown = operandText(address);
  // "mw10" is written as the PLC writes it.
  const name = [shown, address].some((one) => plain(one) === plain(operand)) ? shown : operand;
  return { name, others: [shown, symbol].filter((one) => one !== '' && plain(one) !== plain(name)) };
}

/** In a lane or at a column there is room for one name. */
export const titleOf = (curve: Curve): string => curve.symbol || namesOf(curve).name;

/** Curves of one unit share an axis. */
export const scaleOf = (curve: Curve) => (curve.bits === 1 ? 'bits' : `unit ${curve.unit}`);

/** Timers and counters, too, are whole numbers. */
export const isWhole = ({ bits, type }: Curve): boolean => bits > 1 && type !== 'REAL';

/** The part of the chart's height that the lanes of bits take. */
export function laneShare(curves: Curve[]): number {
  const bits = curves.filter((curve) => curve.bits === 1).length;
  if (bits === 0) return 0;
  return bits === curves.length ? 1 : Math.min(0.5, 0.08 * bits + 0.06);
}

/**
 * The text of a CSV file: the rows of a stretch of time, as RFC 4180 wants them; a German spreadsheet reads semicolons and
 * decimal commas.
 */
export function csv(columns: Columns, curves: Curve[], from: number, to: number, german = false): string {
  const separator = german ? ';' : ',';
  const quoted = (text: string) => (/[",;\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
  const title = (curve: Curve) => (curve.symbol || curve.operand) + (curve.unit ? ` [${curve.unit}]` : '');
  const number = (text: string) => (german ? text.replace('.', ',') : text);
  const lines = [[german ? 'Zeit [s]' : 'time [s]', ...curves.map(title)].map(quoted).join(separator)];
  columns[0].forEach((time, row) => {
    if (time < from || time > to) return;
    const values = columns.slice(1).map((column) => number(String(column[row] ?? '')));
    lines.push([number(time.toFixed(3)), ...values].join(separator));
  });
  return `${lines.join('\r\n')}\r\n`;
}

/** As short as it is exact enough to read. */
export function shownValue(curve: Curve, value: number | null | undefined): string {
  if (value === null || value === undefined) return '–';
  const text = inNumbers(Number.isInteger(value) ? String(value) : value.toPrecision(5));
  return curve.unit ? `${text} ${curve.unit === 'degC' ? '°C' : curve.unit}` : text;
}
