// Breakpoints beside the line numbers (S7-EDIT-22): a click or F9 sets and clears them; the line where the program stands
// in HALT is marked.
import { RangeSet, StateEffect, StateField, type Extension, type StateEffectType } from '@codemirror/state';
import { Decoration, EditorView, gutter, GutterMarker, keymap } from '@codemirror/view';

class Dot extends GutterMarker {
  constructor(readonly kind: 'point' | 'halt' | 'failed') {
    super();
  }
  override eq(other: Dot): boolean {
    return other.kind === this.kind;
  }
  override toDOM(): HTMLElement {
    const element = document.createElement('span');
    element.className = `cm-${this.kind}-mark`;
    element.textContent = { point: '●', halt: '▶', failed: '✖' }[this.kind];
    return element;
  }
}

const point = new Dot('point');
const here = new Dot('halt');
const failed = new Dot('failed');

export const setBreakpoints = StateEffect.define<readonly number[]>();
export const setHaltLine = StateEffect.define<number | null>();
/** The statement that stopped the CPU. */
export const setFailedLine = StateEffect.define<number | null>();

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

/** A line that has a look of its own. */
const lineField = (effect: StateEffectType<number | null>, look: string) =>
  StateField.define<number | null>({
    create: () => null,
    update: (line, transaction) =>
      transaction.effects.reduce((value, one) => (one.is(effect) ? one.value : value), line),
    provide: (field) =>
      EditorView.decorations.compute([field, 'doc'], (state) => {
        const line = state.field(field);
        if (line === null || line < 1 || line > state.doc.lines) return Decoration.none;
        return Decoration.set(Decoration.line({ class: look }).range(state.doc.line(line).from));
      }),
  });
const haltField = lineField(setHaltLine, 'cm-halt-line');
const failedField = lineField(setFailedLine, 'cm-failed-line');
const markers = [
  { field: haltField, marker: here },
  { field: failedField, marker: failed },
];

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
    failedField,
    gutter({
      class: 'cm-breakpoint-gutter',
      lineMarker: (view, block) => {
        const line = view.state.doc.lineAt(block.from).number;
        return markers.find(({ field }) => view.state.field(field) === line)?.marker ?? null;
      },
      lineMarkerChange: (update) =>
        markers.some(({ field }) => update.startState.field(field) !== update.state.field(field)),
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
