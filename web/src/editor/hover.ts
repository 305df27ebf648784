// What an operand or symbol under the pointer is, and its value in the CPU.
import type { Extension } from '@codemirror/state';
import { hoverTooltip } from '@codemirror/view';
import type { SymbolIndex } from './catalogue';
import { initialState, tokenizeLine, type Token } from './lexer';
import { operandIn, type Mnemonics } from './mnemonics';

export interface HoverHooks {
  symbols: () => SymbolIndex;
  mnemonics: () => Mnemonics;
  /** The value as text; undefined where there is none. */
  read: (operand: string) => Promise<string | undefined>;
}

/** Code has one state at the beginning of each of its lines, so a line is enough to know its words. */
export function operandAt(line: string, column: number): Token | undefined {
  const tokens = tokenizeLine(line, { ...initialState(), section: 'code' });
  return tokens.find(
    (token) => (token.kind === 'operand' || token.kind === 'symbol') && token.from <= column && column <= token.to,
  );
}

function tooltip(title: string, comment: string, value: Promise<string | undefined>): HTMLElement {
  const dom = document.createElement('div');
  dom.className = 'cm-operand-tooltip';
  dom.append(title);
  void value.then((text) => {
    if (text === undefined) return;
    const strong = dom.appendChild(document.createElement('strong'));
    strong.textContent = ` = ${text}`;
  });
  if (comment) {
    const small = document.createElement('div');
    small.className = 'cm-problem-hint';
    small.textContent = comment;
    void value.then(() => dom.append(small));
  }
  return dom;
}

export function operandHover({ symbols, mnemonics, read }: HoverHooks): Extension {
  return hoverTooltip((view, position) => {
    const line = view.state.doc.lineAt(position);
    const token = operandAt(line.text, position - line.from);
    if (!token) return null;
    const symbol = token.kind === 'symbol' ? symbols().ofName(token.text) : symbols().ofOperand(token.text);
    const operand = symbol?.operand ?? token.text;
    if (token.kind === 'symbol' && !symbol) return null;
    const title = symbol ? `${operandIn(symbol.operand, mnemonics())}  "${symbol.name}"  ${symbol.type}` : operand;
    return {
      pos: line.from + token.from,
      end: line.from + token.to,
      create: () => ({ dom: tooltip(title, symbol?.comment ?? '', read(operand)) }),
    };
  });
}
