// A value of the program status in the notation of its type, as STEP 7 shows it: 5, W#16#00FF, S5T#50MS, C#7.

const hex = (bits: number, digits: number): string => bits.toString(16).toUpperCase().padStart(digits, '0');

const units: [name: string, milliseconds: number][] = [
  ['D', 86_400_000],
  ['H', 3_600_000],
  ['M', 60_000],
  ['S', 1000],
  ['MS', 1],
];

function lengthOf(milliseconds: number): string {
  if (milliseconds === 0) return '0MS';
  let rest = milliseconds;
  let text = '';
  for (const [name, size] of units) {
    const count = Math.floor(rest / size);
    if (count > 0) text += `${count}${name}`;
    rest -= count * size;
  }
  return text;
}

/** Three digits of BCD. */
const digits = (bits: number): number => Number.parseInt((bits & 0xfff).toString(16), 10);
const base = (bits: number): number => (bits >> 12) & 3;

function real(bits: number): string {
  const view = new DataView(new ArrayBuffer(4));
  view.setUint32(0, bits);
  return Number(view.getFloat32(0).toPrecision(6)).toString();
}

/** STEP 5: exponent in the high byte, mantissa in 24 bits, both in two's complement. */
const floating = (bits: number): string =>
  Number((((bits << 8) >> 8) * 2 ** ((bits >> 24) - 23)).toPrecision(6)).toString();

const time = (bits: number): string => (bits < 0 ? `T#-${lengthOf(-bits)}` : `T#${lengthOf(bits)}`);

function timeOfDay(bits: number): string {
  const two = (value: number) => String(Math.floor(value)).padStart(2, '0');
  const seconds = bits / 1000;
  const parts = [seconds / 3600, (seconds / 60) % 60, seconds % 60].map(two);
  return `TOD#${parts.join(':')}.${String(bits % 1000).padStart(3, '0')}`;
}

const date = (days: number): string => `D#${new Date(Date.UTC(1990, 0, 1 + days)).toISOString().slice(0, 10)}`;

const forms: Record<string, (bits: number) => string> = {
  BOOL: (bits) => String(bits & 1),
  BYTE: (bits) => `B#16#${hex(bits & 0xff, 2)}`,
  WORD: (bits) => `W#16#${hex(bits & 0xffff, 4)}`,
  DWORD: (bits) => `DW#16#${hex(bits >>> 0, 8)}`,
  CHAR: (bits) => `'${String.fromCharCode(bits & 0xff)}'`,
  INT: (bits) => String((bits << 16) >> 16),
  DINT: (bits) => String(bits | 0),
  REAL: real,
  S5TIME: (bits) => `S5T#${lengthOf(digits(bits) * 10 ** (base(bits) + 1))}`,
  TIME: (bits) => time(bits | 0),
  DATE: (bits) => date(bits & 0xffff),
  TIME_OF_DAY: timeOfDay,
  COUNTER: (bits) => `C#${digits(bits)}`,
  KT: (bits) => `KT ${digits(bits)}.${base(bits)}`,
  KZ: (bits) => `KZ ${digits(bits)}`,
  KG: floating,
};
export type ValueType = string;

export const formOf = (bits: number, type: ValueType): string => (forms[type] ?? forms['DWORD']!)(bits);

const isTimer = (box: string): boolean => /^S_(IMPULS|VIMP|S?EVERZ|AVERZ|PULSE|PEXT|ODTS?|OFFDT)$/.test(box);
const isCounter = (box: string): boolean => /^(ZAEHLER|Z_VORW|Z_RUECK|S_C(UD?|D))$/.test(box);
const isCoilOfTimer = (coil: string): boolean => /^S[IVESAPDF]$/.test(coil);

/** In and out of what makes one type of another one. */
const conversions: Record<string, [from: string, to: string]> = {
  BCD_I: ['WORD', 'INT'],
  I_BCD: ['INT', 'WORD'],
  I_DI: ['INT', 'DINT'],
  BCD_DI: ['DWORD', 'DINT'],
  DI_BCD: ['DINT', 'DWORD'],
  DI_R: ['DINT', 'REAL'],
};
const letters: Record<string, string> = {
  I: 'INT',
  D: 'DINT',
  DI: 'DINT',
  R: 'REAL',
  W: 'WORD',
  DW: 'DWORD',
  F: 'INT',
  G: 'KG',
};

export interface ValuePlace {
  /** Name of the box or coil: "ADD_R", "SE". */
  box: string;
  /** Empty: the value of a coil. */
  pin: string;
  isOutput: boolean;
  bcd: boolean;
}

/** What the pin takes or gives; undefined: anything, as MOVE does. */
export function pinType({ box, pin, isOutput, bcd }: ValuePlace): ValueType | undefined {
  const isCoil = pin === '';
  const step5 = !isCoil && (isCoilOfTimer(box) || box === 'Z');
  if (isTimer(box) || isCoilOfTimer(box)) return bcd || !isOutput ? (step5 ? 'KT' : 'S5TIME') : 'INT';
  if (isCounter(box) || box === 'Z' || (isCoil && /^S[ZC]$/.test(box)))
    return bcd || !isOutput ? (step5 ? 'KZ' : 'COUNTER') : 'INT';
  if (pin === 'N') return 'INT';
  const conversion = conversions[box];
  if (conversion) return conversion[isOutput ? 1 : 0];
  if (/^(ROUND|TRUNC|CEIL|FLOOR)$/.test(box)) return isOutput ? 'DINT' : 'REAL';
  if (/^(ABS|SQRT?|EXP|LN|A?(SIN|COS|TAN))$/.test(box)) return 'REAL';
  return letters[/(?:_|[<>=])(I|DI?|R|D?W|F|G)$/.exec(box)?.[1] ?? ''];
}

/** Of an operand that nobody has declared: MB 5, DBW 2, ED 4. */
function widthOf(operand: string): ValueType | undefined {
  const letter = /([A-Z])\s*\d+$/.exec(operand)?.[1] ?? '';
  return { B: 'BYTE', Y: 'BYTE', L: 'BYTE', R: 'BYTE', W: 'WORD', D: 'DWORD' }[letter];
}

const isPattern = (type: string): boolean => /^(BYTE|D?WORD)$/.test(type);

/** As it is declared; bits without a meaning have that of the pin. */
export function typeOf(declared: string | undefined, operand: string, place: ValuePlace): ValueType {
  const wanted = pinType(place);
  if (declared && !(wanted && isPattern(declared))) return declared;
  const width = widthOf(operand);
  // What is wider than a byte was cut off.
  return (width === 'BYTE' ? width : wanted) ?? width ?? 'DWORD';
}
