// Pictures of a plant as text files of the project, one symbol a line: kind ; x ; y ; width ; height ; operand ; text ; from ; to
// docs/formats/picture.md

export const WIDTH = 960;
export const HEIGHT = 540;
/** Symbols stand on this grid. */
export const GRID = 10;
const MOST = 500;

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
const HEAD = '// kind ; x ; y ; width ; height ; operand ; text ; from ; to';
export const hasLevel = (kind: Kind): boolean => kind === 'tank' || kind === 'bar';

const onGrid = (value: number): number => Math.round(value / GRID) * GRID;
const within = (value: number, least: number, most: number): number => Math.min(Math.max(value, least), most);

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
  const item = { kind, x: 0, y: 0, width, height, operand: '', text: '', from: 0, to: 100 };
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

export function printPicture(items: readonly Item[]): string {
  const line = ({ kind, x, y, width, height, operand, text, from, to }: Item): string =>
    [kind, x, y, width, height, quoted(one(operand)), quoted(one(text)), ...(hasLevel(kind) ? [from, to] : [])]
      .join(' ; ')
      .replace(/[ ;]+$/, '');
  return [HEAD, ...items.map(line), ''].join('\n');
}

/** Lines that are none of a symbol come back by their numbers: the file may have been written by hand. */
export function parsePicture(text: string): { items: Item[]; wrong: number[] } {
  const items: Item[] = [];
  const wrong: number[] = [];
  text.split(/\r?\n/).forEach((line, index) => {
    if (line.trim() === '' || line.trim().startsWith('//')) return;
    const item = parsed(line);
    if (item && items.length < MOST) items.push(item);
    else wrong.push(index + 1);
  });
  return { items, wrong };
}

function parsed(line: string): Item | undefined {
  const fields = (line.match(/(?:"[^"]*"|[^;"]|"(?![^"]*"))+|;/g) ?? []).reduce<string[]>(
    (list, part) => (part === ';' ? [...list, ''] : [...list.slice(0, -1), list.at(-1)! + part]),
    [''],
  );
  const [kind = '', x, y, width, height, operand = '', text = '', from, to] = fields.map((field) => field.trim());
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
  };
  const good = kinds.includes(item.kind) && Object.values(item).every((value) => !Number.isNaN(value));
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

/** An operand without a type is shown in hexadecimal elsewhere; on a picture people read numbers. */
export const plainNumber = (text: string, raw: number | null, bits: number): string =>
  raw !== null && /^D?[BW]#16#/i.test(text) ? String(signed(raw, bits, '')) : text;

/** A path for a picture that a user named. */
export function picturePath(name: string): string {
  const plain = name.trim().replace(/[\\/:*?"<>|]+/g, '-');
  return plain.toLowerCase().endsWith('.hmi') ? plain : `${plain}.hmi`;
}
