// The words of a STEP 5 listing (docs/formats/listing.md), for its colours: heads, networks, declarations, statements.
import type { TokenKind } from './lexer';

export interface ListingState {
  /** Where in the line: its beginning, the operation, what it acts on, or nothing but text to its end. */
  at: 'start' | 'operation' | 'operand' | 'title';
}

export const listingStart = (): ListingState => ({ at: 'start' });

type Rule = readonly [pattern: RegExp, kind: TokenKind, then: ListingState['at']];

const comment: Rule = [/^(?:\/\/|;|!(?!=)).*/, 'comment', 'operand'];
const rules: Record<ListingState['at'], readonly Rule[]> = {
  start: [
    comment,
    [/^(?:NETZWERK|NETWORK|SEGMENT)\s+\d+/i, 'keyword', 'title'],
    [/^(?:OB|PB|SB|FB|DB)\s*\d+\b(?!\s*:)/i, 'keyword', 'operand'],
    [/^(?:NAME|BEZ|DECL)\s*:/i, 'keyword', 'operand'],
    [/^\*\*\*/, 'keyword', 'operand'],
    [/^\d+\s*:(?=\s*K[A-Z]\b)/i, 'number', 'operand'],
    [/^[A-Z]\w{0,3}\s*:/i, 'label', 'operation'],
    [/^:/, 'punctuation', 'operation'],
  ],
  operation: [comment, [/^(?:[<>=!]+\s*[FDG]?\b|=|[-+*/]\s*[FDG]\b|[A-Z]+\(?|\))/i, 'instruction', 'operand']],
  operand: [
    comment,
    [/^=[A-Z]\w*/i, 'symbol', 'operand'],
    [/^K[A-Z]\s*=?/i, 'type', 'operand'],
    [/^(?:[EIAQMDPZT][BWDLR]?|OB|PB|SB|FB|DB|DX|OY|OW)\s*\d+(?:\.\d+)?/i, 'operand', 'operand'],
    [/^[+-]?[\dA-F]*\d[\dA-F.,]*\b/i, 'number', 'operand'],
    [/^[A-Z_]\w*/i, 'name', 'operand'],
  ],
  title: [[/^.+/, 'text', 'title']],
};

/** The token that `rest` begins with; changes the state. */
export function nextOfListing(rest: string, state: ListingState): { length: number; kind: TokenKind } {
  const space = /^\s+/.exec(rest);
  if (space) return { length: space[0].length, kind: 'space' };
  for (const [pattern, kind, then] of rules[state.at]) {
    const match = pattern.exec(rest);
    if (!match) continue;
    state.at = then;
    return { length: match[0].length, kind };
  }
  // A line without a colon begins with its operation.
  if (state.at === 'start') {
    state.at = 'operation';
    return nextOfListing(rest, state);
  }
  return { length: 1, kind: 'punctuation' };
}
