// Variable tables as text files of the project, one row a line: operand ; format ; modify value
// docs/formats/variable-table.md

import { FORMATS } from '../state/formats';
import { cellsOf, isTable } from '../state/pasted';
import { triggerLine } from './triggers';

export interface Row {
  operand: string;
  format: string;
  modify: string;
}

const known = new Set(FORMATS.map(([name]) => name));
const HEAD = '// operand ; format ; modify value';

/** A line about the rows below it, as STEP 7's tables have them, or one that names no operand: they stay as they are. */
export const isComment = (row: Row): boolean => /^\s*(\/\/|;)/.test(row.operand);
/** Not for a comment or an empty row. */
export const hasOperand = (row: Row): boolean => row.operand.trim() !== '' && !isComment(row);

/** Without the empty rows at the end: they are there to be typed into. */
export function withoutEnd(rows: Row[]): Row[] {
  let end = rows.length;
  while (end > 0 && rows[end - 1]!.operand.trim() === '') --end;
  return rows.slice(0, end);
}

const lineOf = (row: Row): string =>
  hasOperand(row) ? [row.operand, row.format, row.modify].join(' ; ').replace(/[ ;]+$/, '') : row.operand.trim();

/** `triggers`: a line about them, or none. */
export function printTable(rows: Row[], triggers = ''): string {
  return [HEAD, ...(triggers ? [triggers] : []), ...withoutEnd(rows).map(lineOf), ''].join('\n');
}

/** Lines about the table itself are no rows. A semicolon in quotation marks belongs to the operand. */
export function parseTable(text: string): Row[] {
  const lines = text.split(/\r?\n/).map((line) => line.trim());
  const triggers = lines.indexOf(triggerLine(lines) ?? HEAD);
  return withoutEnd(lines.filter((line, index) => line !== HEAD && index !== triggers).map(rowOf));
}

function rowOf(line: string): Row {
  if (/^(\/\/|;)/.test(line)) return { operand: line, format: 'AUTO', modify: '' };
  const [operand = '', format = '', ...modify] = line.match(/(?:"[^"]*"|'[^']*'|[^;])+|;/g)?.reduce(fields, ['']) ?? [];
  return { operand: operand.trim(), format: format.trim() || 'AUTO', modify: modify.join(';').trim() };
}

/** Rows from the clipboard: one a line, columns by tabs or semicolons; a range is several. None for a single operand, which is
 * typed text. */
export function pastedRows(text: string): Row[] {
  if (!isTable(text) && !text.trim().includes(';')) return [];
  const lines = cellsOf(text).map((cells) => cells.join(' ; '));
  return parseTable(lines.join('\n')).flatMap(({ operand: first, format, modify }) => {
    const operand = first.startsWith(';') ? '' : first;
    const row = { operand, format: known.has(format.toUpperCase()) ? format.toUpperCase() : 'AUTO', modify };
    const operands = rangeOf(operand);
    return operands.length > 1 ? operands.map((one) => ({ ...row, operand: one })) : [row];
  });
}

const MOST_OF_A_RANGE = 1000;
const widths: Record<string, number> = { B: 8, W: 16, D: 32 };

const place = (name: string) => String.raw`(?<${name}>\d+)(?:\.(?<${name}Bit>[0-7]))?`;
const area = String.raw`(?:DB\s?\d+\.)?[A-Z]+`;
/** From one operand to another one, which may leave out the area: MW 10..20, E 0.0-E 0.7. */
const range = new RegExp(
  String.raw`^\s*(?<area>${area})\s*${place('first')}\s*(?:\.\.|[-–])\s*(?:(?<again>${area})\s*)?${place('last')}\s*$`,
  'i',
);
const plain = (name: string): string => name.replace(/\s/g, '').toUpperCase();

/** "MW 10..20" and "E 0.0 - E 1.7" are an operand each 16 bits and each bit; nothing for what is no range, or one of more than 1,000. */
export function rangeOf(text: string): string[] {
  const { area = '', again = area, first, firstBit, last, lastBit } = range.exec(text)?.groups ?? {};
  if (plain(again) !== plain(area)) return [];
  const bits = firstBit !== undefined;
  if (bits !== (lastBit !== undefined)) return [];
  const begin = bits ? Number(first) * 8 + Number(firstBit) : Number(first);
  const end = bits ? Number(last) * 8 + Number(lastBit) : Number(last);
  const step = bits || /^[TZC]$/i.test(area) ? 1 : (widths[area.slice(-1).toUpperCase()] ?? 0) / 8;
  const count = step > 0 ? Math.floor((end - begin) / step) + 1 : 0;
  if (count < 1 || count > MOST_OF_A_RANGE) return [];
  return Array.from({ length: count }, (_, index) => {
    const at = begin + index * step;
    return bits ? `${area} ${Math.floor(at / 8)}.${at % 8}` : `${area} ${at}`;
  });
}

function fields(list: string[], part: string): string[] {
  if (part === ';') return [...list, ''];
  return [...list.slice(0, -1), list[list.length - 1] + part];
}

/** A path for a table that a user named: "press 1" is press 1.vat. */
export function tablePath(name: string): string {
  const plain = name.trim().replace(/[\\/:*?"<>|]+/g, '-');
  return plain.toLowerCase().endsWith('.vat') ? plain : `${plain}.vat`;
}
