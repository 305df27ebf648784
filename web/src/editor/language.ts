// AWL for CodeMirror: the lexer of this folder as a stream language, and its colours.
import {
  HighlightStyle,
  LanguageSupport,
  StreamLanguage,
  syntaxHighlighting,
  type StringStream,
} from '@codemirror/language';
import { tags, type Tag } from '@lezer/highlight';
import { isListing } from './listing_outline';
import { listingStart, nextOfListing, type ListingState } from './listing_lexer';
import { initialState, next, startLine, type LexerState, type Section, type TokenKind } from './lexer';

const tagOf: Record<Exclude<TokenKind, 'space'>, Tag> = {
  comment: tags.comment,
  keyword: tags.keyword,
  text: tags.docString,
  instruction: tags.operatorKeyword,
  label: tags.labelName,
  operand: tags.atom,
  symbol: tags.variableName,
  local: tags.local(tags.variableName),
  number: tags.number,
  string: tags.string,
  type: tags.typeName,
  name: tags.propertyName,
  punctuation: tags.punctuation,
};

function token(stream: StringStream, state: LexerState): string | null {
  if (stream.sol()) startLine(state);
  const { length, kind } = next(stream.string.slice(stream.pos), state);
  stream.pos += Math.max(1, length);
  return kind === 'space' ? null : kind;
}

function listingToken(stream: StringStream, state: ListingState): string | null {
  if (stream.sol()) Object.assign(state, listingStart());
  const { length, kind } = nextOfListing(stream.string.slice(stream.pos), state);
  stream.pos += Math.max(1, length);
  return kind === 'space' ? null : kind;
}

const step5 = StreamLanguage.define<ListingState>({
  name: 'step5',
  startState: listingStart,
  copyState: (state) => ({ ...state }),
  token: listingToken,
  tokenTable: tagOf,
  languageData: { commentTokens: { line: '//' } },
});

const define = (section: Section): StreamLanguage<LexerState> =>
  StreamLanguage.define<LexerState>({
    name: 'awl',
    startState: () => ({ ...initialState(), section }),
    copyState: (state) => ({ ...state }),
    token,
    tokenTable: tagOf,
    languageData: {
      commentTokens: { line: '//', block: { open: '(*', close: '*)' } },
      closeBrackets: { brackets: ['"', "'"] },
    },
  });

// Instructions carry the weight, what they act on the colour; the rest steps back.
const colours = HighlightStyle.define([
  { tag: tags.comment, color: 'var(--code-comment)', fontStyle: 'italic' },
  { tag: tags.keyword, color: 'var(--code-keyword)' },
  { tag: tags.docString, color: 'var(--code-title)', fontWeight: '600' },
  { tag: tags.operatorKeyword, color: 'var(--code-instruction)', fontWeight: '600' },
  { tag: tags.labelName, color: 'var(--code-label)', fontWeight: '600' },
  { tag: tags.atom, color: 'var(--code-operand)' },
  { tag: [tags.variableName, tags.local(tags.variableName)], color: 'var(--code-symbol)' },
  { tag: [tags.number, tags.string], color: 'var(--code-number)' },
  { tag: tags.typeName, color: 'var(--code-keyword)' },
  { tag: tags.punctuation, color: 'var(--code-comment)' },
]);

const source = define('head');
// What the CPU lists of a block: instructions only.
const listing = define('code');

export const awlSupport = (ofCpu = false): LanguageSupport =>
  new LanguageSupport(ofCpu ? listing : source, [syntaxHighlighting(colours)]);

const listingSupport = (): LanguageSupport => new LanguageSupport(step5, [syntaxHighlighting(colours)]);

/** By the name of the file: STEP 5 listings, AWL. `ofCpu`: what the CPU lists of a block. */
export const supportFor = (path: string, ofCpu: boolean): LanguageSupport =>
  isListing(path) ? listingSupport() : awlSupport(ofCpu);
