// What may stand at the cursor (S7-EDIT-17): instructions at the beginning of a statement, then symbols, local variables,
// blocks or labels, as the instruction takes them.
import type { Completion, CompletionContext, CompletionResult, CompletionSource } from '@codemirror/autocomplete';
import { said, translator } from '../i18n';
import { language } from '../i18n/language.svelte';
import { instructions } from '../i18n/texts/instructions';
import type { Catalogue, MnemonicRow } from './catalogue';
import { initialState, tokenizeLine, type LexerState, type Token } from './lexer';
import { mnemonicsOf, type Mnemonics } from './mnemonics';
import { blockAt, outline, type BlockOutline } from './outline';

const meaning = translator(instructions);
const calls = /^(CALL|UC|CC|AUF|OPN)$/;
const jumps = /^(SP[A-Z]+|J[A-Z]+|LOOP)$/;

export interface Place {
  tokens: readonly Token[]; // of the line, up to the cursor
  section: LexerState['section'];
  parameters: boolean;
}

/** The lexer's view of the cursor: what stands before it in the line, and where that line is. */
export function placeOf(text: string, offset: number): Place {
  const lines = text.slice(0, offset).split('\n');
  const state = initialState();
  const tokens = lines.map((line) => tokenizeLine(line, state)).at(-1) ?? [];
  return { tokens: sinceSemicolon(tokens), section: state.section, parameters: state.parameters };
}

function sinceSemicolon(tokens: readonly Token[]): readonly Token[] {
  return tokens.slice(tokens.map((token) => token.text).lastIndexOf(';') + 1);
}

const symbolOptions = (catalogue: Catalogue): Completion[] =>
  catalogue.symbols.map((symbol) => ({
    label: `"${symbol.name}"`,
    detail: `${symbol.operand}  ${symbol.type}`,
    info: symbol.comment || undefined,
    type: 'symbol',
  }));

const localOptions = (block: BlockOutline | undefined): Completion[] =>
  (block?.declarations ?? [])
    .filter((row) => row.depth === 0)
    .map((row) => ({
      label: `#${row.name}`,
      detail: `${row.declaration}  ${row.type}`,
      info: row.comment || undefined,
      type: 'local',
    }));

const blockOptions = (catalogue: Catalogue): Completion[] =>
  catalogue.blocks.map((block) => ({ label: block.id, detail: block.symbol || block.title, type: 'block' }));

const labelOptions = (block: BlockOutline | undefined): Completion[] =>
  (block?.labels ?? []).map((label) => ({ label, type: 'label' }));

const instructionOption = ([word, operands, id]: MnemonicRow): Completion => ({
  label: word,
  detail: operands.split(', ').map(said).join(', '),
  info: id in instructions ? meaning(id as keyof typeof instructions) : undefined,
  type: 'instruction',
});

/** Made once in a language: they are asked for at each key. */
let made: { of: readonly MnemonicRow[]; language: string; options: Completion[] } | undefined;
function instructionOptions(catalogue: Catalogue, mnemonics: Mnemonics): Completion[] {
  const of = catalogue.mnemonics[mnemonics];
  if (made?.of !== of || made.language !== language.value)
    made = { of, language: language.value, options: of.map(instructionOption) };
  return made.options;
}

const keywords = [
  'NETWORK',
  'TITLE =',
  'BEGIN',
  'VAR_INPUT',
  'VAR_OUTPUT',
  'VAR_IN_OUT',
  'VAR',
  'VAR_TEMP',
  'END_VAR',
  'ORGANIZATION_BLOCK',
  'FUNCTION',
  'FUNCTION_BLOCK',
  'DATA_BLOCK',
  'END_ORGANIZATION_BLOCK',
  'END_FUNCTION',
  'END_FUNCTION_BLOCK',
  'END_DATA_BLOCK',
].map((label): Completion => ({ label, type: 'keyword' }));

/** What may be an operand: local variables, symbols, blocks. */
export const operandOptions = (block: BlockOutline | undefined, catalogue: Catalogue): Completion[] => [
  ...localOptions(block),
  ...symbolOptions(catalogue),
  ...blockOptions(catalogue),
];

/** All that fits at `offset` of `text`; `word` is what has been typed of it. */
export function optionsAt(text: string, offset: number, word: string, catalogue: Catalogue): Completion[] {
  const place = placeOf(text, offset - word.length);
  const block = blockAt(outline(text), text.slice(0, offset).split('\n').length);
  if (place.section !== 'code') return keywords;
  const first = place.tokens.find((token) => token.kind === 'instruction')?.text.toUpperCase() ?? '';
  if (!first && !place.parameters)
    return [...instructionOptions(catalogue, mnemonicsOf(text)), ...keywords.slice(0, 2)];
  if (jumps.test(first)) return labelOptions(block);
  const operands = [...localOptions(block), ...symbolOptions(catalogue)];
  return calls.test(first) ? [...blockOptions(catalogue), ...operands] : operands;
}

/** The word before the cursor: a symbol with its blanks, a local variable, an instruction. */
export const typedWord = /(?:"[^"\n]*|#[\w.]*|[A-Za-z_][\w]*|[=<>+*/-]+[A-Z]?)$/;

// Without being asked for, nothing may come between a finished word and the Enter key: no list for an instruction that is
// complete, none for the first letters of an absolute operand.
function wanted(word: string, options: readonly Completion[]): boolean {
  if (/^["#]/.test(word)) return true;
  const kinds = new Set(options.map((option) => option.type));
  if (kinds.has('instruction')) return word !== '' && !options.some((option) => option.label === word.toUpperCase());
  return word.length >= 3;
}

export function completionSource(catalogue: () => Catalogue): CompletionSource {
  return (context: CompletionContext): CompletionResult | null => {
    const word = context.matchBefore(typedWord)?.text ?? '';
    if (word === '' && !context.explicit) return null;
    const options = optionsAt(context.state.doc.toString(), context.pos, word, catalogue());
    if (!context.explicit && !wanted(word, options)) return null;
    return { from: context.pos - word.length, options, validFor: /^"[^"\n]*"?$|^#[\w.]*$/ };
  };
}
