// The words of AWL, line by line: one lexer for colours, outline, conversion of mnemonics and symbolic display.
// It never refuses anything: what is wrong is said by the compiler (program.check).

export type TokenKind =
  | 'comment'
  | 'keyword'
  | 'text'
  | 'instruction'
  | 'label'
  | 'operand'
  | 'symbol'
  | 'local'
  | 'number'
  | 'string'
  | 'type'
  | 'name'
  | 'punctuation'
  | 'space';

export type Section = 'head' | 'declarations' | 'code' | 'data';

export interface LexerState {
  section: Section;
  block: string; // keyword the block began with, "" outside
  start: boolean; // a statement begins here
  parameters: boolean; // inside the list of a CALL
  comment: boolean; // inside (* ... *)
  title: 'none' | 'word' | 'text'; // behind TITLE, behind its equals sign
}

export interface Token {
  kind: TokenKind;
  from: number; // column in the line
  to: number;
  text: string;
}

export const initialState = (): LexerState => ({
  section: 'head',
  block: '',
  start: true,
  parameters: false,
  comment: false,
  title: 'none',
});

const blockKeywords = /^(ORGANIZATION_BLOCK|FUNCTION_BLOCK|FUNCTION|DATA_BLOCK|TYPE)\b/i;
const endKeywords = /^(END_ORGANIZATION_BLOCK|END_FUNCTION_BLOCK|END_FUNCTION|END_DATA_BLOCK|END_TYPE)\b/i;
const declarationKeywords = /^(VAR_INPUT|VAR_OUTPUT|VAR_IN_OUT|VAR_TEMP|VAR|STRUCT|END_STRUCT|END_VAR)\b/i;
const textKeywords = /^(TITLE|AUTHOR|FAMILY|NAME|VERSION)(?=\s*[=:])/i;
const headKeywords = /^(KNOW_HOW_PROTECT|READ_ONLY|UNLINKED|NON_RETAIN|CODE_VERSION1|STANDARD)\b/i;
const types =
  /^(BOOL|BYTE|WORD|DWORD|INT|DINT|REAL|CHAR|STRING|S5TIME|TIME_OF_DAY|TIME|DATE_AND_TIME|DATE|TOD|DT|TIMER|COUNTER|ARRAY|OF|STRUCT|POINTER|ANY|VOID|BLOCK_(?:FB|FC|DB|SDB))\b/i;
const constants =
  /^(?:(?:S5T|S5TIME|T|TIME|D|DATE|TOD|TIME_OF_DAY|DT|DATE_AND_TIME|C|Z|B|W|DW|L|P|2|8|16|BYTE|WORD|DWORD)#[^\s;,)\]/]+(?:\s+\d+\.\d+)?|(?:TRUE|FALSE)\b|[+-]?\d[\d_]*(?:\.\d+(?:[eE][+-]?\d+)?)?)/i;
// An area with its address ("E 0.0", "MW 10", "DB5.DBW 2"), a block or one of the registers.
const operand =
  /^(?:(?:(?:DB|DI)\s?\d+\.DB[XBWD]|P[EIAQ][BWD]|[EIAQML][BWD]?|D[BI][XBWD]|[TZC]|DB|DI|FB|FC|OB|SFB|SFC|UDT)\s*(?:\d+(?:\.\d+)?|(?=\[))|STW\b|AR[12]\b|BIE\b|BR\b|OV\b|OS\b|UO\b|(?:DBLG|DILG|DBNO|DINO)\b|[<>=]=?>?0\b)/i;
const instruction =
  /^(?:\)MCR|MCR\(|\)|=(?!=)|==[IDR]|<>[IDR]|[<>]=?[IDR]|\+AR[12]|[-+*/][IDR]\b|\+|RND[-+]?|NOP\s+[01]|[A-Z_][A-Z0-9_]*\(?)/i;

type Rule = readonly [RegExp, TokenKind];
const common: readonly Rule[] = [
  [/^"[^"]*"?/, 'symbol'],
  [/^'(?:\$.|[^'$])*'?/, 'string'],
  [/^#"[^"]*"?|^#[\w.[\]]+/, 'local'],
];
const operandRules: readonly Rule[] = [
  ...common,
  [constants, 'number'],
  [operand, 'operand'],
  [/^[A-Z_]\w*/i, 'name'],
  [/^./, 'punctuation'],
];
const dataRules: readonly Rule[] = [
  ...common,
  [constants, 'number'],
  [types, 'type'],
  [operand, 'operand'],
  [/^[A-Z_]\w*/i, 'name'],
  [/^./, 'punctuation'],
];

// The length and kind of the token that begins at `rest`; changes the state.
export function next(rest: string, state: LexerState): { length: number; kind: TokenKind } {
  if (state.comment) return blockComment(rest, state);
  const space = /^\s+/.exec(rest);
  if (space) return { length: space[0].length, kind: 'space' };
  if (state.title === 'text') return { length: rest.length, kind: 'text' };
  if (rest.startsWith('//')) return { length: rest.length, kind: 'comment' };
  if (rest.startsWith('(*')) {
    state.comment = true;
    return blockComment(rest, state);
  }
  if (rest[0] === ';') {
    state.start = true;
    state.parameters = false;
    return { length: 1, kind: 'punctuation' };
  }
  return keyword(rest, state) ?? statement(rest, state);
}

function blockComment(rest: string, state: LexerState): { length: number; kind: TokenKind } {
  const end = rest.indexOf('*)', rest.startsWith('(*') ? 2 : 0);
  state.comment = end < 0;
  return { length: end < 0 ? rest.length : end + 2, kind: 'comment' };
}

function keyword(rest: string, state: LexerState): { length: number; kind: TokenKind } | undefined {
  // A header may go on in the line of its block: DATA_BLOCK DB 41 SFB 41 BEGIN.
  if (!state.start) return state.section === 'head' && state.block ? headKeyword(rest, state) : undefined;
  const found = (match: RegExpExecArray): { length: number; kind: TokenKind } => ({
    length: match[0].length,
    kind: 'keyword',
  });
  let match = blockKeywords.exec(rest);
  if (match) {
    Object.assign(state, { section: 'head', block: match[1]!.toUpperCase(), start: false });
    return found(match);
  }
  if ((match = endKeywords.exec(rest))) {
    Object.assign(state, { section: 'head', block: '' });
    return found(match);
  }
  if ((match = /^BEGIN\b/i.exec(rest))) {
    state.section = state.block === 'DATA_BLOCK' ? 'data' : 'code';
    return found(match);
  }
  if ((match = /^NETWORK\b/i.exec(rest))) return found(match);
  if ((match = textKeywords.exec(rest)) && state.section !== 'declarations' && state.section !== 'data') {
    state.start = false;
    if (/^TITLE/i.test(rest)) state.title = 'word';
    return found(match);
  }
  if (state.section === 'code' || state.section === 'data') return undefined;
  if ((match = declarationKeywords.exec(rest))) {
    state.section = /^END_VAR/i.test(match[0]) ? 'head' : 'declarations';
    return found(match);
  }
  if ((match = headKeywords.exec(rest))) return found(match);
  return undefined;
}

function headKeyword(rest: string, state: LexerState): ReturnType<typeof keyword> {
  if (![textKeywords, headKeywords, declarationKeywords, /^BEGIN\b/i].some((words) => words.test(rest)))
    return undefined;
  state.start = true;
  return keyword(rest, state);
}

function statement(rest: string, state: LexerState): { length: number; kind: TokenKind } {
  if (state.title === 'word' && rest[0] === '=') state.title = 'text';
  if (state.section === 'code' && state.start) return beginning(rest, state);
  if (state.section === 'head' && /^[=:]/.test(rest) && !state.start) return { length: 1, kind: 'punctuation' };
  state.start = false;
  if (state.section === 'code' && rest[0] === '(') state.parameters = true;
  if (state.section === 'code' && rest[0] === ')') state.parameters = false;
  return byRules(rest, state.section === 'code' ? operandRules : dataRules, state);
}

// The first word of a statement: label or instruction.
function beginning(rest: string, state: LexerState): { length: number; kind: TokenKind } {
  const label = /^[A-Z_]\w*\s*:(?!=)/i.exec(rest);
  if (label) return { length: label[0].length, kind: 'label' };
  state.start = false;
  const word = instruction.exec(rest);
  if (!word) return { length: 1, kind: 'punctuation' };
  return { length: word[0].length, kind: 'instruction' };
}

function byRules(rest: string, rules: readonly Rule[], state: LexerState): { length: number; kind: TokenKind } {
  if (state.parameters) {
    const parameter = /^[A-Z_]\w*(?=\s*:=)/i.exec(rest);
    if (parameter) return { length: parameter[0].length, kind: 'name' };
  }
  for (const [pattern, kind] of rules) {
    const match = pattern.exec(rest);
    if (match && match[0].length > 0) return { length: match[0].length, kind };
  }
  return { length: 1, kind: 'punctuation' };
}

// A new line begins a statement, except inside the parameters of a CALL.
export function startLine(state: LexerState): void {
  state.title = 'none';
  if (!state.parameters) state.start = true;
}

interface Read {
  tokens: readonly Token[];
  after: LexerState;
}
/** Lines that were read, by the state before them: at a key all lines but one are as they were. */
const known = new Map<string, Map<string, Read>[]>();
const KNOWN_AT_MOST = 50_000;
let knownLines = 0;

const sections: readonly Section[] = ['head', 'declarations', 'code', 'data'];
const titles: readonly LexerState['title'][] = ['none', 'word', 'text'];
/** All of a state but its block: a small number is found faster than a text. */
const numberOf = ({ section, title, start, parameters, comment }: LexerState): number =>
  ((sections.indexOf(section) * 3 + titles.indexOf(title)) << 3) |
  (Number(start) | (Number(parameters) << 1) | (Number(comment) << 2));

function linesBehind(state: LexerState): Map<string, Read> {
  let states = known.get(state.block);
  if (!states) known.set(state.block, (states = []));
  return (states[numberOf(state)] ??= new Map<string, Read>());
}

export function tokenizeLine(line: string, state: LexerState): readonly Token[] {
  if (knownLines > KNOWN_AT_MOST) {
    known.clear();
    knownLines = 0;
  }
  const lines = linesBehind(state);
  let read = lines.get(line);
  if (!read) {
    const tokens = readTokens(line, state);
    lines.set(line, (read = { tokens, after: { ...state } }));
    knownLines += 1;
  }
  Object.assign(state, read.after);
  return read.tokens;
}

function readTokens(line: string, state: LexerState): Token[] {
  const tokens: Token[] = [];
  startLine(state);
  let from = 0;
  while (from < line.length) {
    const { length, kind } = next(line.slice(from), state);
    if (kind !== 'space') tokens.push({ kind, from, to: from + length, text: line.slice(from, from + length) });
    from += length;
  }
  return tokens;
}
