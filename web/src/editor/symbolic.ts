// Symbolic or absolute display (S7-EDIT-18): the text stays as it was written, what is shown changes. The operand under
// the cursor always shows what is really there.
import { syntaxTree } from '@codemirror/language';
import { Facet, RangeSetBuilder, type EditorState, type Extension } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin, WidgetType, type DecorationSet, type ViewUpdate } from '@codemirror/view';
import { SymbolIndex } from './catalogue';
import { operandIn, type Mnemonics } from './mnemonics';

export type Display = 'written' | 'symbolic' | 'absolute';

export interface DisplaySetting {
  display: Display;
  /** Of the text, in whose words it is shown. */
  mnemonics: Mnemonics;
  symbols: SymbolIndex;
}

export const displaySetting = Facet.define<DisplaySetting, DisplaySetting>({
  combine: (values) => values[0] ?? { display: 'written', mnemonics: 'german', symbols: new SymbolIndex([]) },
});

class ShownOperand extends WidgetType {
  constructor(
    readonly text: string,
    readonly written: string,
  ) {
    super();
  }
  override eq(other: ShownOperand): boolean {
    return other.text === this.text;
  }
  override toDOM(): HTMLElement {
    const element = document.createElement('span');
    element.className = 'cm-shown-operand';
    element.textContent = this.text;
    element.title = this.written;
    return element;
  }
  override ignoreEvent(): boolean {
    return false;
  }
}

/** What a word shows in this display; undefined: as it is written. */
export function shownAs(
  kind: string,
  text: string,
  { display, mnemonics, symbols }: DisplaySetting,
): string | undefined {
  if (display === 'symbolic' && kind === 'operand') {
    const symbol = symbols.ofOperand(text);
    return symbol && `"${symbol.name}"`;
  }
  const symbol = display === 'absolute' && kind === 'symbol' ? symbols.ofName(text) : undefined;
  return symbol && operandIn(symbol.operand, mnemonics);
}

function decorations(view: EditorView): DecorationSet {
  const setting = view.state.facet(displaySetting);
  const builder = new RangeSetBuilder<Decoration>();
  if (setting.display === 'written') return builder.finish();
  for (const { from, to } of view.visibleRanges)
    syntaxTree(view.state).iterate({
      from,
      to,
      enter: (node) => {
        if (node.name !== 'operand' && node.name !== 'symbol') return;
        const written = view.state.sliceDoc(node.from, node.to);
        const shown = shownAs(node.name, written, setting);
        if (shown === undefined || touched(view.state, node.from, node.to)) return;
        builder.add(node.from, node.to, Decoration.replace({ widget: new ShownOperand(shown, written) }));
      },
    });
  return builder.finish();
}

const touched = (state: EditorState, from: number, to: number): boolean =>
  state.selection.ranges.some((range) => range.from <= to && range.to >= from);

export const symbolicDisplay: Extension = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;
    constructor(view: EditorView) {
      this.decorations = decorations(view);
    }
    update(update: ViewUpdate): void {
      const changed = update.startState.facet(displaySetting) !== update.state.facet(displaySetting);
      const parsed = syntaxTree(update.startState) !== syntaxTree(update.state);
      if (changed || parsed || update.docChanged || update.viewportChanged || update.selectionSet)
        this.decorations = decorations(update.view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);
