// Pictures of a plant as text files of the project, one symbol a line:
// kind ; x ; y ; width ; height ; operand ; text ; from ; to ; format
// docs/formats/picture.md
import { inNumbers } from '../i18n';

export const WIDTH = 960;
export const HEIGHT = 540;
/** Symbols stand on this grid. */
export const GRID = 10;
export const MOST = 500;

export const kinds = ['tank', 'motor', 'valve', 'belt', 'lamp', 'button', 'number', 'bar', 'text'] as const;
export type Kind = (typeof kinds)[number];

export interface Item {
  kind: Kind;
  x: number;
  y: number;
  width: number;
  height: number;
  operand: string;
  text: string;
  /** Of a level: empty and full. */
  from: number;
  to: number;
  /** Of a number and a level, as in a variable table: AUTO is what the operand is declared as. */
  format: string;
  /** The line of the file, where the page writes it otherwise: it stays until the symbol is changed. */
  written?: string;
  /** Lines of the file before it that are no symbol: comments, empty ones. */
  above?: string[];
}

/** As large as people expect them; a button for a finger. */
const sizes: Record<Kind, readonly [width: number, height: number]> = {
  tank: [90, 140],
  motor: [60, 60],
  valve: [60, 40],
  belt: [240, 30],
  lamp: [40, 40],
  button: [110, 50],
  number: [110, 40],
  bar: [30, 140],
  text: [160, 30],
};
const OLD_HEAD = '// kind ; x ; y ; width ; height ; operand ; text ; from ; to';
const HEAD = `${OLD_HEAD} ; format`;
export const hasLevel = (kind: Kind): boolean => kind === 'tank' || kind === 'bar';
export const hasFormat = (kind: Kind): boolean => kind === 'number' || hasLevel(kind);

export const onGrid = (value: number): number => Math.round(value / GRID) * GRID;
export const within = (value: number, least: number, most: number): number => Math.min(Math.max(value, least), most);

/** On the grid and in the picture, whatever was asked for. */
export function placed(item: Item): Item {
  const width = within(onGrid(item.width), 2 * GRID, WIDTH);
  const height = within(onGrid(item.height), 2 * GRID, HEIGHT);
  return {
    ...item,
    width,
    height,
    x: within(onGrid(item.x), 0, WIDTH - width),
    y: within(onGrid(item.y), 0, HEIGHT - height),
  };
}

/** Where nothing lies yet, row by row; else in the middle. */
export function fresh(kind: Kind, items: readonly Item[]): Item {
  const [width, height] = sizes[kind];
  const item = { kind, x: 0, y: 0, width, height, operand: '', text: '', from: 0, to: 100, format: 'AUTO' };
  // With room for a caption.
  const room = 2 * GRID;
  const apart = (one: Item, x: number, y: number) =>
    one.x >= x + width + room ||
    one.x + one.width + room <= x ||
    one.y >= y + height + room ||
    one.y + one.height + room <= y;
  const free = (x: number, y: number) => items.every((one) => apart(one, x, y));
  for (let y = 2 * GRID; y + height <= HEIGHT; y += GRID)
    for (let x = 2 * GRID; x + width <= WIDTH; x += GRID) if (free(x, y)) return { ...item, x, y };
  return placed({ ...item, x: (WIDTH - width) / 2, y: (HEIGHT - height) / 2 });
}

/** A field that has a semicolon stands in quotation marks, as a symbol does. */
const quoted = (text: string): string =>
  text.includes(';') && !text.startsWith('"') ? `"${text.replace(/"/g, "'")}"` : text;
const one = (text: string): string => text.replace(/[\r\n]+/g, ' ').trim();

/** `end`: the lines below the last symbol. */
export function printPicture(items: readonly Item[], end: readonly string[] = []): string {
  return [HEAD, ...items.flatMap((item) => [...(item.above ?? []), keptLine(item)]), ...end, ''].join('\n');
}

function printed({ kind, x, y, width, height, operand, text, from, to, format }: Item): string {
  const levels = hasLevel(kind) ? [from, to] : ['', ''];
  const last = hasFormat(kind) && format !== 'AUTO' ? one(format) : '';
  return [kind, x, y, width, height, quoted(one(operand)), quoted(one(text)), ...levels, last]
    .join(' ; ')
    .replace(/[ ;]+$/, '');
}

/** As somebody wrote it, as long as it means the symbol that is there. */
function keptLine(item: Item): string {
  const was = item.written === undefined ? undefined : parsed(item.written);
  return was && printed(was) === printed(item) ? item.written! : printed(item);
}

/** The file may have been written by hand: lines that should be symbols come back by their numbers, those beyond the most symbols by
 * how many they are; all lines stay in the file. */
export function parsePicture(text: string): { items: Item[]; wrong: number[]; beyond: number; end: string[] } {
  const items: Item[] = [];
  const wrong: number[] = [];
  let beyond = 0;
  let others: string[] = [];
  text.split(/\r?\n/).forEach((line, index) => {
    if ([HEAD, OLD_HEAD].includes(line.trim())) return;
    const plain = line.trim() === '' || line.trim().startsWith('//');
    const item = plain ? undefined : parsed(line);
    if (item && items.length < MOST) {
      const written = printed(item) === line.trimEnd() ? {} : { written: line.trimEnd() };
      items.push({ ...item, ...written, ...(others.length > 0 ? { above: others } : {}) });
      others = [];
    } else {
      others.push(line.trimEnd());
      if (item) beyond++;
      else if (!plain) wrong.push(index + 1);
    }
  });
  while (others.at(-1) === '') others.pop();
  return { items, wrong, beyond, end: others };
}

function parsed(line: string): Item | undefined {
  const fields = (line.match(/(?:"[^"]*"|[^;"]|"(?![^"]*"))+|;/g) ?? []).reduce<string[]>(
    (list, part) => (part === ';' ? [...list, ''] : [...list.slice(0, -1), list.at(-1)! + part]),
    [''],
  );
  const [kind = '', x, y, width, height, operand = '', text = '', from, to, format = ''] = fields.map((field) =>
    field.trim(),
  );
  const number = (field: string | undefined, otherwise?: number): number =>
    field ? Number(field) : (otherwise ?? Number.NaN);
  const item = {
    kind: kind as Kind,
    x: number(x),
    y: number(y),
    width: number(width),
    height: number(height),
    operand,
    text: /^".*;.*"$/.test(text) ? text.slice(1, -1) : text,
    from: number(from, 0),
    to: number(to, 100),
    format: format.toUpperCase() || 'AUTO',
  };
  const good =
    kinds.includes(item.kind) && Object.values(item).every((one) => typeof one === 'string' || Number.isFinite(one));
  return good ? placed(item) : undefined;
}

/** How full, from 0 to 1. */
export function level({ from, to }: Pick<Item, 'from' | 'to'>, value: number | null): number {
  return value === null || from === to ? 0 : within((value - from) / (to - from), 0, 1);
}

/** A number of this many bits with its sign, as a level and a number mean it. */
export function signed(raw: number | null, bits: number, type: string): number | null {
  if (raw === null || /REAL|WORD|BYTE|BOOL|CHAR/i.test(type) || bits <= 8 || bits > 32) return raw;
  return Number.isInteger(raw) && raw >= 2 ** (bits - 1) ? raw - 2 ** bits : raw;
}

/** What a level fills to: the value in its format. */
export function amount(raw: number | null, bits: number, type: string, format: string): number | null {
  if (format === 'AUTO') return signed(raw, bits, type);
  return format === 'DEC' ? signed(raw, bits, '') : raw;
}

/** The value of a number in its format; without one as people read it. */
export function shownNumber(text: string, raw: number | null, bits: number, type: string, format: string): string {
  return format === 'AUTO' || format === 'REAL' ? plainNumber(text, raw, bits, type) : text;
}

/** The type that somebody declared: an address without a symbol has only a width. */
export const declared = (operand: string, symbol: string, type: string): string =>
  symbol === '' && /^(DB ?\d+\.)?[A-Z]+ ?\d+(\.\d)?$/i.test(operand.trim()) ? '' : type;

/** Bit strings are hexadecimal elsewhere, a REAL has an exponent; on a picture people read numbers, with a comma in
 * German. Without a type: with sign. */
export function plainNumber(text: string, raw: number | null, bits: number, type = ''): string {
  if (raw === null) return text;
  if (/^D?[BW]#16#/i.test(text)) return String(signed(raw, bits, type));
  return /^-?\d\.\d+e[+-]\d+$/i.test(text) ? inNumbers(String(Number(raw.toPrecision(7)))) : text;
}

/** What an operator types, as a constant of the language: 21,5 and 21 for a REAL, 5s for a TIME, words for a STRING. */
export function constantOf(typed: string, shown: string, type: string): { value: string; format: string } {
  const value = typed.trim();
  if (/^(BYTE|WORD|DWORD)$/i.test(type) && /^\d+$/.test(value)) return { value, format: 'UDEC' };
  if (/^REAL$/i.test(type) && /^[+-]?\d+([.,]\d+)?$/.test(value))
    return {
      value: value.includes(',') ? value.replace(',', '.') : value.includes('.') ? value : `${value}.0`,
      format: 'AUTO',
    };
  if (/^(STRING|CHAR)/i.test(type) && !value.startsWith("'")) return { value: `'${value}'`, format: 'AUTO' };
  const prefix = /^[A-Z0-9]+#(?!16#)/i.exec(shown)?.[0] ?? '';
  return { value: value.includes('#') ? value : prefix + value, format: 'AUTO' };
}

/** The same for a number that has a format. */
export function typedIn(typed: string, shown: string, type: string, format: string): { value: string; format: string } {
  if (format === 'AUTO') return constantOf(typed, shown, type);
  return { value: format === 'REAL' ? constantOf(typed, '', 'REAL').value : typed.trim(), format };
}

/** A path for a picture that a user named. */
export function picturePath(name: string): string {
  const plain = name.trim().replace(/[\\/:*?"<>|]+/g, '-');
  return plain.toLowerCase().endsWith('.hmi') ? plain : `${plain}.hmi`;
}
