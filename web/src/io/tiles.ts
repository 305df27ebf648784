// Which operand a tile shows and what can be done with it. Both mnemonics: E/I, A/Q, Z/C.

import { among, isText, objectOf } from '../state/alike';

export type TileKind = 'channels' | 'value' | 'timer' | 'counter';

export interface Tile {
  operand: string;
  kind: TileKind;
  bits: 8 | 16 | 32;
  format: string;
}

export const isTile = objectOf({
  operand: isText,
  kind: among('channels', 'value', 'timer', 'counter'),
  bits: among(8, 16, 32),
  format: isText,
});

const WIDTH = { B: 8, W: 16, D: 32 } as const;
/** "eb0" is the tile EB 0; undefined is no operand that a tile can show. */
export function parseTile(text: string): Tile | undefined {
  const typed = text.trim().toUpperCase().replace(/\s+/g, ' ');
  return timerOrCounter(typed) ?? memory(typed) ?? dataWord(typed);
}

function timerOrCounter(text: string): Tile | undefined {
  const [, area, number] = /^([TZC]) ?(\d+)$/.exec(text) ?? [];
  if (!area) return undefined;
  const operand = `${area} ${Number(number)}`;
  return area === 'T'
    ? { operand, kind: 'timer', bits: 16, format: 'S5TIME' }
    : { operand, kind: 'counter', bits: 16, format: 'COUNTER' };
}

function memory(text: string): Tile | undefined {
  const [, area, width, byte] = /^(E|I|A|Q|M|PE|PI|PA|PQ)([BWD]) ?(\d+)$/.exec(text) ?? [];
  if (!area || !width) return undefined;
  const bits = WIDTH[width as keyof typeof WIDTH];
  const kind = bits === 8 && !area.startsWith('P') ? 'channels' : 'value';
  return { operand: `${area}${width} ${Number(byte)}`, kind, bits, format: 'HEX' };
}

function dataWord(text: string): Tile | undefined {
  const [, block, width, byte] = /^DB ?(\d+)\. ?DB([BWD]) ?(\d+)$/.exec(text) ?? [];
  if (!block || !width) return undefined;
  const bits = WIDTH[width as keyof typeof WIDTH];
  const operand = `DB${Number(block)}.DB${width} ${Number(byte)}`;
  return { operand, kind: bits === 8 ? 'channels' : 'value', bits, format: 'HEX' };
}

/** The bits of a byte, bit 0 first: EB 0 gives E 0.0 to E 0.7. */
export function bitsOf(tile: Tile): string[] {
  if (tile.kind !== 'channels') return [];
  const [, area, byte] = /^(.+)B (\d+)$/.exec(tile.operand)!;
  const bit = area!.includes('.') ? `${area}X` : area;
  return Array.from({ length: 8 }, (_, index) => `${bit} ${byte}.${index}`);
}

/** From where to where a slider moves: signed for DEC. */
export function rangeOf(bits: number, format: string): [number, number] {
  const span = 2 ** bits;
  return format === 'DEC' ? [-span / 2, span / 2 - 1] : [0, span - 1];
}

/** The position of a slider from the unsigned bits. */
export function sliderValue(raw: number, bits: number, format: string): number {
  return format === 'DEC' && raw >= 2 ** (bits - 1) ? raw - 2 ** bits : raw;
}

/** Operands of a symbol table that a first look should show: bytes of inputs and outputs, timers, counters. */
export function tilesOfSymbols(operands: string[]): Tile[] {
  const found = operands.map((operand) => {
    const [, area, byte] = /^([EIAQ]) ?(\d+)\.\d$/.exec(operand.trim().toUpperCase()) ?? [];
    return parseTile(area ? `${area}B ${byte}` : /^[TZC] ?\d+$/i.test(operand.trim()) ? operand : '');
  });
  const order = (tile: Tile) => 'EIAQTZC'.indexOf(tile.operand[0]!);
  const unique = new Map(found.filter((tile) => tile !== undefined).map((tile) => [tile.operand, tile]));
  return [...unique.values()].sort((a, b) => order(a) - order(b) || number(a) - number(b));
}

const number = (tile: Tile) => Number(/\d+$/.exec(tile.operand)![0]);
