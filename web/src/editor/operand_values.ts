// The value of each operand behind it in the text, live: those of the lines in sight.
import { StateEffect, StateField, type Extension, type Line } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, WidgetType, type DecorationSet, type ViewUpdate } from '@codemirror/view';
import { operandsOf } from './nearby';

/** Of an operand in a line with this text; null: none are shown. */
export type OperandValues = ((written: string, line: number, text: string) => string | undefined) | null;
export const setOperandValues = StateEffect.define<OperandValues>();

export const operandValues = StateField.define<OperandValues>({
  create: () => null,
  update: (values, transaction) =>
    transaction.effects.reduce((now, effect) => (effect.is(setOperandValues) ? effect.value : now), values),
});

class Value extends WidgetType {
  constructor(readonly text: string) {
    super();
  }
  override eq(other: Value): boolean {
    return this.text === other.text;
  }
  override toDOM(): HTMLElement {
    const shown = document.createElement('span');
    shown.className = 'cm-operand-value';
    shown.textContent = this.text;
    return shown;
  }
}

function decorated(view: EditorView): DecorationSet {
  const values = view.state.field(operandValues);
  const found = values ? linesInSight(view).flatMap((line) => behind(line, values)) : [];
  return Decoration.set(found);
}

const behind = ({ from, text, number }: Line, values: NonNullable<OperandValues>) =>
  operandsOf(text).flatMap(({ written, end }) => {
    const value = values(written, number, text);
    return value === undefined ? [] : [Decoration.widget({ widget: new Value(value), side: 1 }).range(from + end)];
  });

function linesInSight(view: EditorView): Line[] {
  const lines: Line[] = [];
  for (const { from, to } of view.visibleRanges)
    for (let at = from; at <= to; ) {
      const line = view.state.doc.lineAt(at);
      lines.push(line);
      at = line.to + 1;
    }
  return lines;
}

const changed = (update: ViewUpdate): boolean =>
  update.docChanged ||
  update.viewportChanged ||
  update.startState.field(operandValues) !== update.state.field(operandValues);

/** `sighted`: which lines can be read from now on. */
export const operandValueDisplay = (sighted: (lines: string[]) => void): Extension => [
  operandValues,
  ViewPlugin.fromClass(
    class {
      decorations: DecorationSet;
      constructor(view: EditorView) {
        this.decorations = decorated(view);
        sighted(linesInSight(view).map(({ text }) => text));
      }
      update(update: ViewUpdate) {
        if (!changed(update)) return;
        this.decorations = decorated(update.view);
        if (update.docChanged || update.viewportChanged) sighted(linesInSight(update.view).map(({ text }) => text));
      }
    },
    { decorations: (plugin) => plugin.decorations },
  ),
];
