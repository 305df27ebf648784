// The rows of the symbol table: their text for drafts, order and filter. What is right or wrong says the server.

import { cellsOf, isTable } from '../state/pasted';

export const fields = ['symbol', 'operand', 'type', 'comment'] as const;
export type Field = (typeof fields)[number];
export type SymbolRow = Record<Field, string>;

export const emptyRow = (): SymbolRow => ({ symbol: '', operand: '', type: '', comment: '' });
export const isEmpty = (row: SymbolRow): boolean => fields.every((field) => row[field].trim() === '');

/** Trailing empty rows are only there to be typed into. */
export function meaningful(rows: readonly SymbolRow[]): SymbolRow[] {
  let length = rows.length;
  while (length > 0 && isEmpty(rows[length - 1]!)) length--;
  return rows.slice(0, length);
}

export const toText = (rows: readonly SymbolRow[]): string => JSON.stringify(meaningful(rows));

export function fromText(text: string): SymbolRow[] {
  const rows = JSON.parse(text) as Partial<SymbolRow>[];
  return rows.map((row) => ({ ...emptyRow(), ...row }));
}

const WIDTHS: Record<string, string> = { B: 'BYTE', W: 'WORD', D: 'DWORD' };

/** The data type that STEP 7 fills in for an operand; empty: what the page does not know says the server. */
export function typeOfOperand(operand: string): string {
  const { bit, width, timer, counter, block, number } =
    /^\s*(?:(?<bit>[EAIQM]\s*\d+\.[0-7])|P?[EAIQM](?<width>[BWD])\s*\d+|(?<timer>T\s*\d+)|(?<counter>[ZC]\s*\d+)|(?<block>OB|FC|FB|SFC|SFB|DB|UDT)\s*(?<number>\d+))\s*$/i.exec(
      operand,
    )?.groups ?? {};
  if (bit) return 'BOOL';
  if (width) return WIDTHS[width.toUpperCase()]!;
  if (timer) return 'TIMER';
  if (counter) return 'COUNTER';
  return block ? `${block.toUpperCase()} ${number}` : '';
}

/** What a spreadsheet writes around a cell with a quotation mark, and a source around each symbol. */
const unquoted = (cell: string): string => /^"+(.*?)"+$/.exec(cell)?.[1] ?? cell;

/** Rows from the clipboard, their first column that of the field; further left where they have more columns. None for a single text. */
export function pastedRows(text: string, field: Field): SymbolRow[] {
  if (!isTable(text)) return [];
  const rows = cellsOf(text);
  const widest = Math.max(...rows.map((cells) => cells.length));
  const first = Math.max(0, Math.min(fields.indexOf(field), fields.length - widest));
  return rows.map((cells) => {
    const values = fields.slice(first).map((name, index): [Field, string] => [name, unquoted(cells[index] ?? '')]);
    return { ...emptyRow(), ...Object.fromEntries(values) };
  });
}

// E 2.0 before E 10.0: numbers inside a text count as numbers.
const collator = new Intl.Collator('de', { numeric: true, sensitivity: 'base' });

export interface Sorting {
  field: Field;
  down: boolean;
}

/** The row numbers that are shown, in their order. */
export function shownRows(rows: readonly SymbolRow[], filter: string, sorting: Sorting | null): number[] {
  const wanted = filter.trim().toLowerCase();
  const found = rows
    .map((_, index) => index)
    .filter((index) => !wanted || fields.some((field) => rows[index]![field].toLowerCase().includes(wanted)));
  if (!sorting) return found;
  const { field, down } = sorting;
  const sign = down ? -1 : 1;
  return found.sort((a, b) => sign * collator.compare(rows[a]![field], rows[b]![field]) || a - b);
}

export const formats = ['asc', 'sdf', 'dif', 'seq'] as const;
export type Format = (typeof formats)[number];

export function formatOf(fileName: string): Format | null {
  const extension = fileName.toLowerCase().split('.').at(-1);
  return formats.find((format) => format === extension) ?? null;
}

/** STEP 7 writes these files in code page 1252; a text that is valid UTF-8 is taken as such. */
export function decode(bytes: ArrayBuffer): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}
