// Values of local variables and parameters: those that the program status has seen at a statement, of the call that it shows.
// The variables themselves are gone when the block ends, so nobody can be asked for them.
import { formOf } from '../network/value_form';
import { operandKey } from './nearby';
import type { BlockOutline } from './outline';
import type { StatusRow } from './status_columns';

/** By line and key of the operand. */
export type LocalValues = ReadonlyMap<number, ReadonlyMap<string, string>>;

const STA = 2;
const AKKU1 = 4;
const OF_CALL = 11;

const local = String.raw`#[A-Za-z_][\w.]*(?:\[[^\]]*\][\w.]*)*`;
const statement = new RegExp(String.raw`^\s*(?:\w+\s*:(?!=)\s*)?([A-Z]+|=)\s+(${local})\s*;`, 'i');
const supplied = new RegExp(String.raw`(\w+)\s*:=\s*(${local})`, 'g');
/** Behind them STA is the bit. */
const query = /^(UN?|ON?|XN?|AN?|=)$/i;
/** Behind them it is not: the row says the bit by its name. */
const own = /^([SR]|FP|FN)$/i;
const transfer = /^[LT]$/i;

/** Declared types, by the way to the variable: "BOX.SIZE", an array by that of its elements. */
export function typesOf(block: BlockOutline): Map<string, string> {
  const types = new Map<string, string>();
  const way: string[] = [];
  for (const { name, type, depth } of block.declarations) {
    way.length = depth;
    way.push(name.toUpperCase());
    types.set(way.join('.'), (/\bOF\s+(\w+)$/i.exec(type)?.[1] ?? type).toUpperCase());
  }
  return types;
}

const typeOf = (types: ReadonlyMap<string, string>, written: string): string | undefined =>
  types.get(
    written
      .slice(1)
      .replace(/\[[^\]]*\]/g, '')
      .toUpperCase(),
  );

/** Bits look alike everywhere in the text. */
const bit: Record<string, string> = { TRUE: '1', FALSE: '0' };

/** What the registers do not say, by upper-case name. */
function given(row: StatusRow): Map<string, string> {
  const values = row[OF_CALL];
  if (typeof values !== 'object') return new Map();
  return new Map(Object.entries(values).map(([name, value]) => [name.toUpperCase(), bit[value] ?? value]));
}

function atStatement(line: string, row: StatusRow, types: ReadonlyMap<string, string>): [string, string] | null {
  const [, operation = '', written = ''] = statement.exec(line.replace(/\/\/.*$/, '')) ?? [];
  const type = typeOf(types, written);
  if (!type) return null;
  if (own.test(operation)) {
    const held = given(row).get(written.slice(1).toUpperCase());
    return held === undefined ? null : [operandKey(written), held];
  }
  if (query.test(operation)) return [operandKey(written), String(row[STA])];
  const bits = Number.parseInt(String(row[AKKU1]), 16);
  if (!transfer.test(operation) || Number.isNaN(bits)) return null;
  return [operandKey(written), formOf(bits, /^(TIMER|COUNTER)$/.test(type) ? 'INT' : type)];
}

/** What the operands of a CALL held stands at its first line; they themselves stand on those below it. */
function atCall(lines: readonly string[], row: StatusRow): [number, string, string][] {
  const values = given(row);
  if (values.size === 0) return [];
  const found: [number, string, string][] = [];
  for (let at = row[0]; at <= lines.length; at++) {
    const text = lines[at - 1]!.replace(/\/\/.*$/, '');
    for (const [, parameter = '', written = ''] of text.matchAll(supplied)) {
      const value = values.get(parameter.toUpperCase());
      if (value !== undefined) found.push([at, operandKey(written), value]);
    }
    if (text.includes(';')) break;
  }
  return found;
}

export function localValues(
  lines: readonly string[],
  block: BlockOutline | undefined,
  rows: readonly StatusRow[] | null,
): LocalValues {
  const values = new Map<number, Map<string, string>>();
  if (!block || !rows) return values;
  const types = typesOf(block);
  const put = (line: number, key: string, value: string) =>
    values.set(line, (values.get(line) ?? new Map<string, string>()).set(key, value));
  for (const row of rows) {
    const seen = atStatement(lines[row[0] - 1] ?? '', row, types);
    if (seen) put(row[0], ...seen);
    for (const one of atCall(lines, row)) put(...one);
  }
  return values;
}
