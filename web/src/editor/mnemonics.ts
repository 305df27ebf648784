// German and international mnemonics (S7-EDIT-24): the words that differ, and a source turned from one into the other.
import { initialState, tokenizeLine, type Token } from './lexer';

export type Mnemonics = 'german' | 'international';

// The rows of src/s7/mc7/operations.inc, in their order; words that are the same in both are left out.
export const instructions: readonly (readonly [german: string, international: string])[] = [
  ['U', 'A'],
  ['UN', 'AN'],
  ['U(', 'A('],
  ['UN(', 'AN('],
  ['SI', 'SP'],
  ['SV', 'SE'],
  ['SE', 'SD'],
  ['SA', 'SF'],
  ['ZV', 'CU'],
  ['ZR', 'CD'],
  ['TAR', 'CAR'],
  ['AUF', 'OPN'],
  ['TDB', 'CDB'],
  ['UW', 'AW'],
  ['UD', 'AD'],
  ['TAW', 'CAW'],
  ['TAD', 'CAD'],
  ['BEA', 'BEU'],
  ['BEB', 'BEC'],
  ['SPA', 'JU'],
  ['SPB', 'JC'],
  ['SPBN', 'JCN'],
  ['SPBB', 'JCB'],
  ['SPBNB', 'JNB'],
  ['SPBI', 'JBI'],
  ['SPBIN', 'JNBI'],
  ['SPO', 'JO'],
  ['SPS', 'JOS'],
  ['SPU', 'JUO'],
  ['SPZ', 'JZ'],
  ['SPP', 'JP'],
  ['SPM', 'JM'],
  ['SPN', 'JN'],
  ['SPMZ', 'JMZ'],
  ['SPPZ', 'JPZ'],
  ['SPL', 'JL'],
];

const areas: readonly (readonly [german: string, international: string])[] = [
  ['PEB', 'PIB'],
  ['PEW', 'PIW'],
  ['PED', 'PID'],
  ['PAB', 'PQB'],
  ['PAW', 'PQW'],
  ['PAD', 'PQD'],
  ['EB', 'IB'],
  ['EW', 'IW'],
  ['ED', 'ID'],
  ['AB', 'QB'],
  ['AW', 'QW'],
  ['AD', 'QD'],
  ['E', 'I'],
  ['A', 'Q'],
  ['Z', 'C'],
  ['BIE', 'BR'],
];

type Pairs = readonly (readonly [german: string, international: string])[];
const table = (rows: Pairs, to: Mnemonics): Map<string, string> => tables.get(rows)![to];
const tables = new Map([instructions, areas].map((rows: Pairs) => [rows, bothWays(rows)]));
function bothWays(rows: Pairs): Record<Mnemonics, Map<string, string>> {
  return {
    international: new Map(rows),
    german: new Map(rows.map(([german, international]) => [international, german])),
  };
}

function convertToken(token: Token, words: Map<string, string>, operands: Map<string, string>): string {
  if (token.kind === 'instruction') return words.get(token.text.toUpperCase()) ?? token.text;
  if (token.kind === 'operand')
    return token.text.replace(/^[A-Z]+/i, (area) => operands.get(area.toUpperCase()) ?? area);
  if (token.kind === 'number') return convertPointer(token.text, operands);
  return token.text;
}

// P#E 1.0 is P#I 1.0; Z#5 is C#5 (both accepted, but shown in their own words).
function convertPointer(text: string, operands: Map<string, string>): string {
  const counter = /^([ZC])(#.*)/i.exec(text);
  if (counter) return (operands.get(counter[1]!.toUpperCase()) ?? counter[1]!) + counter[2]!;
  return text.replace(
    /^(P#)([EIAQ])(?=[\s\d])/i,
    (_, p: string, area: string) => p + (operands.get(area.toUpperCase()) ?? area),
  );
}

// Columns after an instruction stay where they are as long as the blanks allow it.
function replaceInLine(line: string, tokens: readonly Token[], text: (token: Token) => string): string {
  let result = '';
  let at = 0;
  for (const token of tokens) {
    let gap = line.slice(at, token.from);
    const drift = result.length - at;
    if (/^\s{2,}$/.test(gap) && at > 0) gap = ' '.repeat(Math.max(1, gap.length - drift));
    result += gap + text(token);
    at = token.to;
  }
  return result + line.slice(at);
}

export function convertLine(line: string, tokens: readonly Token[], to: Mnemonics): string {
  const words = table(instructions, to);
  const operands = table(areas, to);
  return replaceInLine(line, tokens, (token) => convertToken(token, words, operands));
}

// SE and SP are words of both settings, so a source that is already so stays as it is.
export function convertSource(source: string, to: Mnemonics): string {
  if (mnemonicsOf(source) === to) return source;
  const state = initialState();
  return source
    .split('\n')
    .map((line) => convertLine(line, tokenizeLine(line, state), to))
    .join('\n');
}

// An operand without blanks, in the German form: how operands are compared.
export function sameOperand(operand: string): string {
  const [, area = '', rest = ''] = /^([A-Z]*)\s*(.*)$/i.exec(operand.trim()) ?? [];
  const german = new Map(areas.map(([de, en]) => [en, de]));
  return (german.get(area.toUpperCase()) ?? area.toUpperCase()) + rest.replace(/\s+/g, '').toUpperCase();
}

/** How many more words of a line are German; tokens of a line that was read before are the same. */
const votes = new WeakMap<readonly Token[], number>();
function votesOf(tokens: readonly Token[]): number {
  const found = votes.get(tokens);
  if (found !== undefined) return found;
  const counted = tokens.reduce((sum, token) => sum + vote(token), 0);
  votes.set(tokens, counted);
  return counted;
}

function vote(token: Token): number {
  const word = token.text.toUpperCase();
  const differs = (words: Pairs, one: string) =>
    Number(table(words, 'international').has(one)) - Number(table(words, 'german').has(one));
  if (token.kind === 'instruction') return differs(instructions, word);
  return token.kind === 'operand' ? differs(areas, /^[A-Z]+/.exec(word)?.[0] ?? '') : 0;
}

/** An operand as a text of these mnemonics has it: what stands beside a text speaks as the text does. */
export const operandIn = (operand: string, to: Mnemonics): string =>
  operand.replace(/^[A-Z]+/i, (area) => table(areas, to).get(area.toUpperCase()) ?? area);

// What a source is written in: the setting that more of its words belong to (STEP 7 reads no mixture).
export function mnemonicsOf(source: string): Mnemonics {
  const state = initialState();
  let sum = 0;
  for (const line of source.split('\n')) sum += votesOf(tokenizeLine(line, state));
  return sum >= 0 ? 'german' : 'international';
}
