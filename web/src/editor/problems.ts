// Problems of the compiler at their places in the text (S7-EDIT-06): code, sentence.
import type { Diagnostic } from '@codemirror/lint';
import type { Text } from '@codemirror/state';
import type { Problem } from '../connection';
import { told } from '../i18n';

function render(problem: Problem): Node {
  const element = document.createElement('div');
  const code = element.appendChild(document.createElement('span'));
  code.className = 'cm-problem-code';
  code.textContent = `${problem.code} `;
  element.append(told(problem));
  return element;
}

/** The word a problem stands at; a place behind the text is its end. */
export function rangeOf(doc: Text, line: number, column: number): { from: number; to: number } {
  const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
  const from = Math.min(at.from + Math.max(column - 1, 0), at.to);
  const rest = doc.sliceString(from, at.to);
  const word = /^(?:"[^"]*"?|[^\s;,()]+(?: \d[\d.]*)?|\S)/.exec(rest)?.[0].length ?? 0;
  return word > 0 ? { from, to: from + word } : { from: Math.max(at.from, from - 1), to: from };
}

export function diagnostics(doc: Text, problems: readonly Problem[]): Diagnostic[] {
  return problems
    .filter((problem) => problem.line > 0)
    .map((problem) => ({
      ...rangeOf(doc, problem.line, problem.column),
      severity: problem.severity,
      message: `${problem.code} ${told(problem)}`,
      renderMessage: () => render(problem),
    }));
}
