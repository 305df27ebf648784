// Values of the formal operands of a STEP 5 function block, as the program status has seen them at their statements: a bit is STA, a
// value AKKU 1. What they stand for differs with each call, so nobody else can be asked.
import { formOf } from '../network/value_form';
import type { LocalValues } from './local_values';
import { operandKey } from './nearby';
import type { BlockOutline } from './outline';
import type { StatusRow } from './status_columns';

const STA = 2;
const AKKU1 = 4;

// "BEZ : WZNR E/A/D/B/T/Z: E BI/BY/W/D: BY"; the prompts may be missing.
const declaration =
  /^\s*(?:BEZ|DECL)\s*:\s*(\w+)\s+(?:E\/A\/D\/B\/T\/Z\s*:\s*)?([EADBTZ])\b(?:\s+(?:[A-Z]+\/[A-Z/]+\s*:\s*)?([A-Z]+))?/i;
const statement = /^[^:]*:\s*([A-Z]+|=)\s+(=\w+)/i;
const query = /^(UN?|ON?|=)$/i;
const transfer = /^(LD?|LC|T)$/i;

/** What AKKU 1 has: "KT", "W", by upper-case name. */
function typesOf(lines: readonly string[]): Map<string, string> {
  const types = new Map<string, string>();
  for (const line of lines) {
    const [, name = '', kind = '', type = ''] = declaration.exec(line) ?? [];
    if (name) types.set(name.toUpperCase(), (kind === 'T' || kind === 'Z' ? kind : type).toUpperCase());
  }
  return types;
}

const digits: Record<string, number> = { BY: 2, W: 4, D: 8 };

function valueOf(operation: string, type: string, bits: number): string {
  if (type === 'T' || type === 'Z') {
    if (/^L$/i.test(operation)) return formOf(bits, 'INT');
    return formOf(bits, `K${type}`);
  }
  if (type === 'KF') return `KF ${formOf(bits, 'INT').replace(/^(?=\d)/, '+')}`;
  if (type === 'KT' || type === 'KZ') return formOf(bits, type);
  const wide = digits[type] ?? 4;
  return `KH ${(bits >>> 0).toString(16).toUpperCase().padStart(8, '0').slice(-wide)}`;
}

export function formalValues(
  lines: readonly string[],
  block: BlockOutline | undefined,
  rows: readonly StatusRow[] | null,
): LocalValues {
  const values = new Map<number, Map<string, string>>();
  if (!block || !rows) return values;
  const types = typesOf(lines.slice(block.line - 1, block.end));
  for (const row of rows) {
    const [, operation = '', written = ''] = statement.exec((lines[row[0] - 1] ?? '').replace(/!.*$/, '')) ?? [];
    const type = types.get(written.slice(1).toUpperCase());
    if (type === undefined) continue;
    const bits = Number.parseInt(String(row[AKKU1]), 16);
    if (query.test(operation)) values.set(row[0], new Map([[operandKey(written), String(row[STA])]]));
    else if (transfer.test(operation) && !Number.isNaN(bits))
      values.set(row[0], new Map([[operandKey(written), valueOf(operation, type, bits)]]));
  }
  return values;
}
