// The rows of the symbol table: their text for drafts, order and filter. What is right or wrong says the server.

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
