// How wide the columns of the data view are: values are whole wherever there is room, the comment takes what is left.

export interface ColumnTexts {
  address: string;
  section: string;
  name: string;
  type: string;
  initial: string;
  actual: string;
  comment: string;
}
/** `depth`: how many structures the variable is in. */
type Row = ColumnTexts & { depth: number };

export interface Room {
  /** Of the table, in pixels. */
  width: number;
  /** Of one digit, in pixels, in the size of the text and in the small one. */
  digit: number;
  smallDigit: number;
  /** How long actual values have been, in characters. */
  actual: number;
  /** Whether there are such columns. */
  sections: boolean;
  begun: boolean;
}

/** In pixels; 0 of a column that is not there. */
export interface ColumnWidths {
  address: number;
  section: number;
  name: number;
  type: number;
  initial: number;
  actual: number;
  modify: number;
  comment: number;
  /** Smaller and closer, because the texts find no room otherwise. */
  compact: boolean;
  /** Of one digit. */
  digit: number;
}

/** Up to here, in pixels, the declaration gives way, and comments where no variable has one. */
const NARROW = 760;
/** DT#2026-11-28-12:30:45.123: the longest value but texts. */
const LONGEST = 26;
/** In pixels: so much of a name tells which one it is; it comes before the initial values. */
const NAME = 96;
const INDENT = 16;

/** What a column has in any case, and the edges of a cell, in pixels. */
const ROOMY = {
  address: 56,
  section: 88,
  name: 72,
  type: 64,
  initial: 88,
  actual: 88,
  modify: 112,
  comment: 104,
  padding: 18,
};
const COMPACT = {
  address: 44,
  section: 68,
  name: 60,
  type: 52,
  initial: 48,
  actual: 72,
  modify: 90,
  comment: 76,
  padding: 10,
};
type Measures = typeof ROOMY;

/** The mark of a structure stands before its name. */
const nameWidth = (row: Row, digit: number) => row.name.length * digit + (row.depth + 1) * INDENT;
const longest = (rows: readonly Row[], of: (row: Row) => number) =>
  rows.reduce((most, row) => Math.max(most, of(row)), 0);

function wanted(rows: readonly Row[], room: Room, digit: number, { padding }: Measures) {
  const length = (column: keyof ColumnTexts) => longest(rows, (row) => row[column].length);
  const wide = (characters: number) => Math.ceil(characters * digit) + padding;
  const initial = room.begun ? length('initial') : 0;
  const actual = Math.max(room.actual, length('actual'));
  const name = Math.ceil(longest(rows, (row) => nameWidth(row, digit))) + padding;
  return {
    address: wide(length('address')),
    /** In the order in which they are given room. */
    list: [
      ['actual', wide(Math.min(actual, LONGEST))],
      ['name', Math.min(name, NAME)],
      ['initial', room.begun ? wide(Math.min(initial, LONGEST)) : 0],
      ['name', name],
      ['type', wide(length('type'))],
      ['actual', wide(actual)],
      ['initial', room.begun ? wide(initial) : 0],
    ] as const,
  };
}

/** So many of the list are names and values but long texts: where they fit the room is `good`. */
const VALUES = 4;

function divided(rows: readonly Row[], room: Room, compact: boolean): { widths: ColumnWidths; good: boolean } {
  const measures = compact ? COMPACT : ROOMY;
  const digit = compact ? room.smallDigit : room.digit;
  const { address, list } = wanted(rows, room, digit, measures);
  const wide = room.width > NARROW;
  const comment = rows.some((row) => row.comment !== '')
    ? (wide ? ROOMY : measures).comment
    : wide
      ? measures.comment
      : 0;
  const { padding: _, ...least } = measures;
  const widths = {
    ...least,
    address: Math.max(address, least.address),
    section: room.sections && wide ? least.section : 0,
    initial: room.begun ? least.initial : 0,
    comment,
  };
  let left = room.width - Object.values(widths).reduce((sum, one) => sum + one, 0);
  for (const [column, wish] of list) {
    const more = Math.max(0, Math.min(wish - widths[column], left));
    widths[column] += more;
    left -= more;
  }
  left = Math.max(left, 0);
  widths[comment > 0 || left >= measures.comment ? 'comment' : 'modify'] += left;
  return {
    widths: { ...widths, compact, digit },
    good: list.slice(0, VALUES).every(([column, wish]) => wish <= widths[column]),
  };
}

export function columnWidths(rows: readonly Row[], room: Room): ColumnWidths {
  const roomy = divided(rows, room, false);
  return roomy.good ? roomy.widths : divided(rows, room, true).widths;
}

const CUT = ['name', 'type', 'initial', 'actual', 'comment'] as const;
export type CutColumn = (typeof CUT)[number];

/** What of a row its columns do not show whole. */
export function cutTexts(row: Row, widths: ColumnWidths): CutColumn[] {
  const { digit } = widths;
  const { padding } = widths.compact ? COMPACT : ROOMY;
  const needed = (column: CutColumn) => (column === 'name' ? nameWidth(row, digit) : row[column].length * digit);
  return CUT.filter(
    (column) => row[column] !== '' && widths[column] > 0 && needed(column) + padding > widths[column] + 1,
  );
}
