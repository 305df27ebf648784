// The whole numbers that an operand holds, for what is told when a typed one is none of them.

const ranges: Record<string, readonly [low: number, high: number]> = {
  INT: [-(2 ** 15), 2 ** 15 - 1],
  DINT: [-(2 ** 31), 2 ** 31 - 1],
};

export interface Beyond {
  operand: string;
  value: string;
  type: string;
  low: number;
  high: number;
}

/** Nothing if it fits, is no plain whole number, or the type is another one. */
export function beyond({ operand, type, value }: { operand: string; type: string; value: string }): Beyond[] {
  const range = ranges[type];
  const text = value.trim();
  if (!range || !/^[+-]?\d+$/.test(text)) return [];
  const [low, high] = range;
  return low <= Number(text) && Number(text) <= high ? [] : [{ operand, value: text, type, low, high }];
}

/** What DEC makes of a word and of a double word: "MW 10", "DB1.DBD 4". */
export function typeOf(operand: string, format: string): string {
  const width = /([WD])\s*\d+$/i.exec(operand.trim())?.[1]?.toUpperCase();
  if (format !== 'DEC' || !width) return '';
  return width === 'W' ? 'INT' : 'DINT';
}
