// The text a new block begins with.
import { compareIds } from './block_tree';
import type { BlockEntry, BlockNumbers } from './catalogue';

const keywords: Record<string, string> = {
  OB: 'ORGANIZATION_BLOCK',
  FB: 'FUNCTION_BLOCK',
  FC: 'FUNCTION',
  DB: 'DATA_BLOCK',
  UDT: 'TYPE',
};

export type Family = 'S7' | 'S5';

const kinds: Record<Family, readonly string[]> = {
  S7: ['OB', 'FB', 'FC', 'DB', 'UDT', 'VAT'],
  S5: ['OB', 'PB', 'SB', 'FB', 'DB', 'VAT'],
};

/** "fc1" becomes "FC 1"; null if it is no block that can be written. */
export function blockId(text: string, family: Family = 'S7'): string | null {
  const [, kind = '', number] = /^\s*([A-Z]+)\s*(\d{1,5})\s*$/i.exec(text) ?? [];
  return kinds[family].includes(kind.toUpperCase()) ? `${kind.toUpperCase()} ${Number(number)}` : null;
}

/** A block as everything calls it, however it was written; anything else stays. */
export const plainId = (text: string): string => blockId(text) ?? text.replace(/\s+/g, ' ');

export const isTable = (id: string): boolean => id.startsWith('VAT');
export const fileOf = (id: string, family: Family = 'S7'): string =>
  `${id.replace(' ', '').toLowerCase()}.${isTable(id) ? 'vat' : family === 'S5' ? 's5' : 'awl'}`;

/** Types and tables of variables do not go into the CPU: any number a source can write. */
const KEPT: [number, number] = [0, 65535];
/** Of STEP 5, whatever the machine (S5-BLK-03, S5-BLK-04). */
const step5Numbers: Record<string, [number, number]> = {
  OB: [0, 63],
  PB: [0, 255],
  SB: [0, 255],
  FB: [0, 255],
  DB: [1, 255],
};

/** Which numbers there are, if this is not one of them: "0 … 2047", "1, 10, 35". */
export function otherNumbers(id: string, of: BlockNumbers | null): string | null {
  const [, kind, number] = /^(OB|FB|FC|DB|UDT|VAT) (\d+)$/.exec(id) ?? [];
  if (!of || !kind) return null;
  if (kind === 'OB') return of.OB.includes(Number(number)) ? null : of.OB.join(', ');
  return outside(Number(number), of[kind as 'FB' | 'FC' | 'DB'] ?? KEPT);
}

export function otherStep5Numbers(id: string): string | null {
  const [kind = '', number] = id.split(' ');
  return outside(Number(number), step5Numbers[kind] ?? KEPT);
}

const outside = (number: number, [first, last]: readonly [number, number]): string | null =>
  number >= first && number <= last ? null : `${first} … ${last}`;

/** As STEP 7 asks: with variables of its own, those of a function block, or those of a data type. */
export type DataKind = 'shared' | 'instance' | 'type';
const BASES: Record<DataKind, RegExp> = { shared: /(?!)/, instance: /^S?FB /, type: /^UDT / };

/** What a data block can be made of, and what a CALL names even if it is not compiled yet; in the order of the block tree. */
export function basesOf(kind: DataKind, blocks: readonly BlockEntry[], called = ''): { id: string; symbol: string }[] {
  const found = new Map(blocks.filter(({ id }) => BASES[kind].test(id)).map((one) => [one.id, one.symbol]));
  if (BASES[kind].test(called) && !found.has(called)) found.set(called, '');
  return [...found].map(([id, symbol]) => ({ id, symbol })).sort((a, b) => compareIds(a.id, b.id));
}

/** Whose instance a data block has to be, as the open texts call it: "SFB 44"; empty: nobody calls it. */
export function calledInstance(id: string, texts: Iterable<string>): string {
  const number = /^DB (\d+)$/.exec(id)?.[1];
  if (!number) return '';
  const call = new RegExp(`\\bCALL\\s+(S?FB)\\s*(\\d+)\\s*,\\s*DB\\s*${number}\\b`, 'i');
  for (const text of texts) {
    const [, kind, block] = call.exec(text) ?? [];
    if (kind) return `${kind.toUpperCase()} ${Number(block)}`;
  }
  return '';
}

const structure = 'STRUCT\n  Value : INT ;\nEND_STRUCT ;\n';

const code = (head: string, end: string, sections = ''): string => `${head}
TITLE =
VERSION : 0.1
${sections}BEGIN
NETWORK
TITLE =

${end}
`;

/** A block of a listing (docs/formats/listing.md). */
export function listingText(id: string): string {
  const [kind, number] = id.split(' ');
  if (kind === 'DB') return `${id}\n   0 : KH = 0000\n`;
  return kind === 'FB' ? `${id}\nNAME : FB${number}\n : BE\n` : `${id}\nNETZWERK 1\n : BE\n`;
}

/** `base`: of a data block; `start`: the declaration of the start information of an organization block. */
export function blockText(id: string, { base = '', start = '' } = {}): string {
  const [kind = ''] = id.split(' ');
  const keyword = keywords[kind]!;
  if (kind === 'UDT') return `TYPE ${id}\n${structure}END_TYPE\n`;
  if (kind === 'DB')
    return base
      ? `DATA_BLOCK ${id} ${base}\nBEGIN\nEND_DATA_BLOCK\n`
      : `DATA_BLOCK ${id}\n${structure}BEGIN\nEND_DATA_BLOCK\n`;
  const sections = kind === 'FB' ? 'VAR_INPUT\nEND_VAR\n' : start;
  return code(kind === 'FC' ? `${keyword} ${id} : VOID` : `${keyword} ${id}`, `END_${keyword}`, sections);
}
