import { describe, expect, it } from 'vitest';
import { initialState, tokenizeLine, type LexerState } from './lexer';

const inCode = (): LexerState => ({ ...initialState(), section: 'code', block: 'FUNCTION' });
const kinds = (line: string, state = inCode()): string[] =>
  tokenizeLine(line, state).map((token) => `${token.kind} ${token.text}`);

describe('a line of AWL (S7-EDIT-11)', () => {
  it('is label, operation, operand, comment', () => {
    expect(kinds('M001: U E 0.0; //text')).toEqual([
      'label M001:',
      'instruction U',
      'operand E 0.0',
      'punctuation ;',
      'comment //text',
    ]);
  });
  it('has symbols and local variables (S7-EDIT-16)', () => {
    expect(kinds('U "Light barrier"; = #Box.Left[2];')).toEqual([
      'instruction U',
      'symbol "Light barrier"',
      'punctuation ;',
      'instruction =',
      'local #Box.Left[2]',
      'punctuation ;',
    ]);
  });
  it.each([
    ['==I', 'instruction ==I'],
    ['<>R', 'instruction <>R'],
    ['>=D', 'instruction >=D'],
    ['+I', 'instruction +I'],
    ['+AR1 P#1.0', 'instruction +AR1'],
    ['U(', 'instruction U('],
    [')', 'instruction )'],
    [')MCR', 'instruction )MCR'],
    ['MCR(', 'instruction MCR('],
    ['RND+', 'instruction RND+'],
    ['NOP 0', 'instruction NOP 0'],
    ['+ 5', 'instruction +'],
  ])('knows the operation %s', (line, first) => expect(kinds(line)[0]).toBe(first));
  it.each([
    ['L S5T#2S', 'number S5T#2S'],
    ['L 16#00FF', 'number 16#00FF'],
    ['L -1.5e+3', 'number -1.5e+3'],
    ['L P#E 1.0', 'number P#E 1.0'],
    ["L 'ab'", "string 'ab'"],
    ['U T 1', 'operand T 1'],
    ['U >=0', 'operand >=0'],
    ['L DB5.DBW 2', 'operand DB5.DBW 2'],
    ['L PEW 256', 'operand PEW 256'],
    ['U M [MD 10]', 'operand M '],
  ])('knows the operand of %s', (line, second) => expect(kinds(line)[1]).toBe(second));
  it('names the parameters of a call over several lines', () => {
    const state = inCode();
    expect(kinds('CALL FB 1, DB 1 (', state)).toEqual([
      'instruction CALL',
      'operand FB 1',
      'punctuation ,',
      'operand DB 1',
      'punctuation (',
    ]);
    expect(kinds('  In := E 0.0,', state)).toEqual([
      'name In',
      'punctuation :',
      'punctuation =',
      'operand E 0.0',
      'punctuation ,',
    ]);
    expect(kinds('  Out := A 1.0);', state).at(-1)).toBe('punctuation ;');
    expect(kinds('U E 0.0', state)[0]).toBe('instruction U');
  });
  it('goes through a comment of several lines', () => {
    const state = inCode();
    expect(kinds('U E 0.0 (* one', state).at(-1)).toBe('comment (* one');
    expect(kinds('two *) = A 0.0', state)).toEqual(['comment two *)', 'instruction =', 'operand A 0.0']);
  });
});

describe('around the code', () => {
  it('has keywords, titles and declarations', () => {
    const state = initialState();
    expect(kinds('FUNCTION_BLOCK FB 1', state)).toEqual(['keyword FUNCTION_BLOCK', 'operand FB 1']);
    expect(kinds("TITLE = It's U E 0.0", state)).toEqual(['keyword TITLE', 'punctuation =', "text It's U E 0.0"]);
    expect(kinds('VAR_INPUT', state)).toEqual(['keyword VAR_INPUT']);
    expect(kinds('  Filter : S5TIME := S5T#50MS; // gaps', state)).toEqual([
      'name Filter',
      'punctuation :',
      'type S5TIME',
      'punctuation :',
      'punctuation =',
      'number S5T#50MS',
      'punctuation ;',
      'comment // gaps',
    ]);
    expect(kinds('END_VAR', state)).toEqual(['keyword END_VAR']);
    expect(kinds('BEGIN', state)).toEqual(['keyword BEGIN']);
    expect(state.section).toBe('code');
    expect(kinds('END_FUNCTION_BLOCK', state)).toEqual(['keyword END_FUNCTION_BLOCK']);
  });
  it('assigns values in a data block', () => {
    const state = initialState();
    kinds('DATA_BLOCK DB 1', state);
    kinds('BEGIN', state);
    expect(kinds('  Count := 5;', state)[0]).toBe('name Count');
  });
});

describe('a line that was read before', () => {
  it('is read by the state before it, and leaves the same one behind', () => {
    for (const _ of ['first', 'again']) {
      const state = initialState();
      tokenizeLine('DATA_BLOCK DB 1', state);
      expect(kinds('BEGIN', state)).toEqual(['keyword BEGIN']);
      expect(state.section).toBe('data');
      const code = inCode();
      expect(kinds('(* U E 0.0', code)).toEqual(['comment (* U E 0.0']);
      expect(code.comment).toBe(true);
      expect(kinds('U E 0.0', code)).toEqual(['comment U E 0.0']);
      expect(kinds('U E 0.0')).toEqual(['instruction U', 'operand E 0.0']);
    }
  });
});
