import { describe, expect, it } from 'vitest';
import { SymbolIndex, type Catalogue } from './catalogue';
import { CompletionContext, type CompletionResult } from '@codemirror/autocomplete';
import { EditorState } from '@codemirror/state';
import { completionSource, optionsAt, typedWord } from './completion';

const catalogue: Catalogue = {
  numbers: null,
  symbols: [{ name: 'Motor left', operand: 'A 1.0', type: 'BOOL', comment: 'belt' }],
  blocks: [{ id: 'FC 5', symbol: 'Running time', title: '' }],
  mnemonics: {
    german: [
      ['U', 'bit', 'AND'],
      ['<I', '', 'LT_I'],
    ],
    international: [['A', 'bit', 'AND']],
  },
};

function labels(code: string): string[] {
  const text = `FUNCTION FC 1 : VOID\nVAR_TEMP\n  Edge : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nM001: U E 0.0;\n${code}`;
  const word = typedWord.exec(text)?.[0] ?? '';
  return optionsAt(text, text.length, word, catalogue).map((option) => option.label);
}

describe('completion (S7-EDIT-17)', () => {
  it('says what an instruction does', () => {
    const option = optionsAt('BEGIN\n      <', 13, '<', catalogue).find(({ label }) => label === '<I');
    expect(option?.info).toBe('compare for less than, integer (16 bits)');
  });
  it('offers instructions where a statement begins', () => {
    expect(labels('      ')).toContain('U');
    expect(labels('U E 0.1; ')).toContain('U');
    expect(labels('      S')).not.toContain('"Motor left"');
  });
  it('offers symbols in quotation marks and local variables behind an instruction', () => {
    expect(labels('      U ')).toEqual(['#Edge', '"Motor left"']);
    expect(labels('      U "Mo')).toContain('"Motor left"');
    expect(labels('      CALL FB 1, DB 1 (\n  In := ')).toContain('"Motor left"');
  });
  it('offers blocks to a call and labels to a jump', () => {
    expect(labels('      CALL ')).toContain('FC 5');
    expect(labels('      SPA ')).toEqual(['M001']);
  });
});

describe('the list comes by itself', () => {
  const shown = (code: string): boolean => {
    const text = `FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n${code}`;
    const context = new CompletionContext(EditorState.create({ doc: text }), text.length, false);
    return ((completionSource(() => catalogue)(context) as CompletionResult | null)?.options.length ?? 0) > 0;
  };
  it.each([
    ['      U "', true],
    ['      U #', true],
    ['      U Mot', true],
    ['      U', false],
    ['      U A', false],
    ['      U A 1.0', false],
    ['      ', false],
  ])('%s: %s', (code, expected) => expect(shown(code)).toBe(expected));
});

describe('symbols of operands', () => {
  const index = new SymbolIndex(catalogue.symbols);
  it('are found in both settings and with any blanks', () => {
    expect(index.ofOperand('Q1.0')?.name).toBe('Motor left');
    expect(index.ofName('"motor left"')?.operand).toBe('A 1.0');
    expect(index.ofOperand('A 1.1')).toBeUndefined();
  });
});
