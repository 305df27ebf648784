// Breakpoints beside the line numbers (S7-EDIT-22): a click or F9 sets and clears them; the line where the program stands
// in HALT is marked.
import { RangeSet, StateEffect, StateField, type Extension } from '@codemirror/state';
import { Decoration, EditorView, gutter, GutterMarker, keymap } from '@codemirror/view';

class Dot extends GutterMarker {
  constructor(readonly kind: 'point' | 'halt') {
    super();
  }
  override eq(other: Dot): boolean {
    return other.kind === this.kind;
  }
  override toDOM(): HTMLElement {
    const element = document.createElement('span');
    element.className = `cm-${this.kind}-mark`;
    element.textContent = this.kind === 'halt' ? '▶' : '●';
    return element;
  }
}

const point = new Dot('point');
const here = new Dot('halt');

export const setBreakpoints = StateEffect.define<readonly number[]>();
export const setHaltLine = StateEffect.define<number | null>();

/** Points move with the text until the server says where they are. */
export const breakpointField = StateField.define<RangeSet<GutterMarker>>({
  create: () => RangeSet.empty,
  update: (points, transaction) => {
    points = points.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(setBreakpoints)) {
        const doc = transaction.state.doc;
        const lines = effect.value.filter((line) => line >= 1 && line <= doc.lines);
        points = RangeSet.of(
          lines.map((line) => point.range(doc.line(line).from)),
          true,
        );
      }
    return points;
  },
});

const haltField = StateField.define<number | null>({
  create: () => null,
  update: (line, transaction) =>
    transaction.effects.reduce((value, effect) => (effect.is(setHaltLine) ? effect.value : value), line),
  provide: (field) =>
    EditorView.decorations.compute([field, 'doc'], (state) => {
      const line = state.field(field);
      if (line === null || line < 1 || line > state.doc.lines) return Decoration.none;
      return Decoration.set(Decoration.line({ class: 'cm-halt-line' }).range(state.doc.line(line).from));
    }),
});

export function breakpointLines(view: EditorView): number[] {
  const lines: number[] = [];
  const cursor = view.state.field(breakpointField).iter();
  for (; cursor.value; cursor.next()) lines.push(view.state.doc.lineAt(cursor.from).number);
  return lines;
}

/** `changed` is told all lines of this text that shall have a breakpoint. */
export function breakpointGutter(changed: (lines: number[]) => void): Extension {
  const toggle = (view: EditorView, line: number): boolean => {
    const lines = breakpointLines(view);
    changed(lines.includes(line) ? lines.filter((other) => other !== line) : [...lines, line].sort((a, b) => a - b));
    return true;
  };
  return [
    breakpointField,
    haltField,
    gutter({
      class: 'cm-breakpoint-gutter',
      lineMarker: (view, block) =>
        view.state.doc.lineAt(block.from).number === view.state.field(haltField) ? here : null,
      lineMarkerChange: (update) => update.startState.field(haltField) !== update.state.field(haltField),
      markers: (view) => view.state.field(breakpointField),
      domEventHandlers: {
        mousedown: (view, block) => toggle(view, view.state.doc.lineAt(block.from).number),
      },
    }),
    keymap.of([
      { key: 'F9', run: (view) => toggle(view, view.state.doc.lineAt(view.state.selection.main.head).number) },
    ]),
  ];
}
