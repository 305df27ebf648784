// What a source contains, read from its text while it is being typed: blocks, declarations, networks, labels.
// The compiler knows better, but it needs a text without mistakes; this one takes what is there.
import { initialState, tokenizeLine, type Token } from './lexer';

export type Declaration = 'in' | 'out' | 'in_out' | 'stat' | 'temp';

export interface DeclarationRow {
  line: number; // from 1
  declaration: Declaration;
  name: string;
  type: string;
  initial: string;
  comment: string;
  depth: number; // inside STRUCT
}

export interface SectionRange {
  declaration: Declaration;
  line: number; // of VAR…
  end: number; // of END_VAR, 0 while it is missing
}

export interface Network {
  line: number;
  title: string;
}

export interface BlockOutline {
  keyword: string; // FUNCTION_BLOCK …
  name: string; // as written: FC 1 or "Slider"
  title: string;
  /** A data block or a type has nothing to run. */
  hasCode: boolean;
  /** Whether it may declare variables in sections; a listing has its own form for them. */
  declares: boolean;
  line: number;
  end: number; // last line
  begin: number; // line of BEGIN, 0 without
  sections: SectionRange[];
  declarations: DeclarationRow[];
  networks: Network[];
  labels: string[];
}

const sectionWords: Record<string, Declaration> = {
  VAR_INPUT: 'in',
  VAR_OUTPUT: 'out',
  VAR_IN_OUT: 'in_out',
  VAR_TEMP: 'temp',
  VAR: 'stat',
};

// Which declarations a block may have (S7-EDIT-03).
export function allowedDeclarations(keyword: string): Declaration[] {
  if (keyword === 'FUNCTION_BLOCK') return ['in', 'out', 'in_out', 'stat', 'temp'];
  if (keyword === 'FUNCTION') return ['in', 'out', 'in_out', 'temp'];
  return keyword === 'ORGANIZATION_BLOCK' ? ['temp'] : [];
}

export const sectionKeyword = (declaration: Declaration): string =>
  Object.keys(sectionWords).find((word) => sectionWords[word] === declaration)!;

interface Reader {
  blocks: BlockOutline[];
  block: BlockOutline | undefined;
  depth: number;
}

export function outline(source: string): BlockOutline[] {
  const state = initialState();
  const reader: Reader = { blocks: [], block: undefined, depth: 0 };
  source.split('\n').forEach((text, index) => {
    const tokens = tokenizeLine(text, state);
    const first = tokens.find((token) => token.kind !== 'comment');
    if (first) readLine(reader, tokens, first, text, index + 1);
    if (reader.block) reader.block.end = index + 1;
    if (tokens.some(({ kind, text }) => kind === 'keyword' && /^END_(?!VAR|STRUCT)/i.test(text)))
      reader.block = undefined;
  });
  return reader.blocks;
}

function readLine(reader: Reader, tokens: readonly Token[], first: Token, text: string, line: number): void {
  const word = first.kind === 'keyword' ? first.text.toUpperCase() : '';
  if (/^(ORGANIZATION_BLOCK|FUNCTION_BLOCK|FUNCTION|DATA_BLOCK|TYPE)$/.test(word))
    return beginBlock(reader, word, tokens, text, line);
  const block = reader.block;
  if (!block) return;
  if (block.name === '' && nameKinds.includes(first.kind)) return void (block.name = nameOf(first));
  if (word in sectionWords) {
    block.sections.push({ declaration: sectionWords[word]!, line, end: 0 });
    reader.depth = 0;
  } else if (word === 'END_VAR') endSection(block, line);
  else if (word === 'END_STRUCT') reader.depth -= 1;
  else if (word === 'BEGIN') block.begin = line;
  else if (word === 'NETWORK') block.networks.push({ line, title: '' });
  else if (word === 'TITLE') readTitle(block, text);
  else if (first.kind === 'label') block.labels.push(first.text.replace(/\s*:$/, ''));
  else readDeclaration(reader, block, text, line);
}

const nameKinds: readonly Token['kind'][] = ['operand', 'symbol', 'name', 'type'];
const nameOf = (token: Token): string => token.text.replace(/\s+/g, ' ');

// The first word is the name, whatever type, attributes or comments follow: DATA_BLOCK DB 41 SFB 41 // controller
function beginBlock(reader: Reader, keyword: string, tokens: readonly Token[], text: string, line: number): void {
  const [, name, ...rest] = tokens.filter((token) => token.kind !== 'comment');
  reader.block = {
    keyword,
    name: name && nameKinds.includes(name.kind) ? nameOf(name) : '',
    title: '',
    hasCode: !/^(DATA_BLOCK|TYPE)$/.test(keyword),
    declares: allowedDeclarations(keyword).length > 0,
    line,
    end: line,
    begin: 0,
    sections: [],
    declarations: [],
    networks: [],
    labels: [],
  };
  reader.blocks.push(reader.block);
  reader.depth = 0;
  const next = rest.find((token) => token.kind === 'keyword');
  if (next) readLine(reader, tokens.slice(tokens.indexOf(next)), next, text.slice(next.from), line);
}

function endSection(block: BlockOutline, line: number): void {
  const open = block.sections.at(-1);
  if (open && open.end === 0) open.end = line;
}

function readTitle(block: BlockOutline, text: string): void {
  const title = text.replace(/^\s*TITLE\s*=\s*/i, '').trim();
  const network = block.networks.at(-1);
  if (network) network.title = title;
  else block.title = title;
}

// Attributes may stand between name and type: Name {S7_m_c := 'true'} : INT.
const declaration = /^\s*([A-Za-z_]\w*)\s*(?:\{[^}]*\})?\s*:(?!=)\s*(.*?)\s*(?::=\s*(.*?))?\s*;?\s*(?:\/\/\s?(.*))?$/;

function readDeclaration(reader: Reader, block: BlockOutline, text: string, line: number): void {
  const section = block.sections.at(-1);
  const match = declaration.exec(text);
  if (!section || section.end !== 0 || block.begin !== 0 || !match) return;
  const [, name = '', type = '', initial = '', comment = ''] = match;
  block.declarations.push({
    line,
    declaration: section.declaration,
    name,
    type,
    initial: initial.replace(/;\s*$/, ''),
    comment,
    depth: reader.depth,
  });
  if (/\bSTRUCT$/i.test(type)) reader.depth += 1;
}

export const blockAt = (blocks: readonly BlockOutline[], line: number): BlockOutline | undefined =>
  blocks.find((block) => block.line <= line && line <= block.end);

// A declaration as the source has it; columns as in the other lines of the section.
export function declarationText(row: Pick<DeclarationRow, 'name' | 'type' | 'initial' | 'comment'>): string {
  const initial = row.initial ? ` := ${row.initial}` : '';
  return `  ${row.name} : ${row.type}${initial} ;${row.comment ? `   // ${row.comment}` : ''}`;
}
