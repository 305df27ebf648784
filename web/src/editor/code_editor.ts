// The editor of one text: CodeMirror with everything AWL needs, in a shadow root.
import {
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  completionKeymap,
  startCompletion,
} from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, redo, undo } from '@codemirror/commands';
import { bracketMatching, indentUnit } from '@codemirror/language';
import { setDiagnostics } from '@codemirror/lint';
import { gotoLine, highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Annotation, Compartment, EditorState, type Extension } from '@codemirror/state';
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
  scrollPastEnd,
  type KeyBinding,
  type ViewUpdate,
} from '@codemirror/view';
import type { Problem } from '../connection';
import { breakpointGutter, setBreakpoints, setFailedLine, setHaltLine } from './breakpoints';
import type { Catalogue } from './catalogue';
import { codeTheme } from './code_theme';
import { completionSource } from './completion';
import { initialState, tokenizeLine } from './lexer';
import { supportFor } from './language';
import { operandValueDisplay, setOperandValues, type OperandValues } from './operand_values';
import { operandHover, type HoverHooks } from './hover';
import { phrases } from './phrases';
import { diagnostics } from './problems';
import { setStatus, statusDisplay, statusField, type StatusRow } from './status_columns';
import { textChanges } from './text_changes';
import { displaySetting, symbolicDisplay, type DisplaySetting } from './symbolic';

export interface EditorHooks extends HoverHooks {
  label: string;
  catalogue: () => Catalogue;
  /** `typed`: by keys, one character after the other. */
  edited: (text: string, typed: boolean) => void;
  moved: (line: number) => void;
  /** The lines that can be read. */
  sighted: (lines: string[]) => void;
  breakpoints: (lines: number[]) => void;
  keys: KeyBinding[];
}

const operandKinds = new Set(['operand', 'symbol', 'local', 'name']);
const fromOutside = Annotation.define<boolean>();

const isTyped = (update: ViewUpdate): boolean =>
  update.transactions.every((one) => !one.docChanged || one.isUserEvent('input.type') || one.isUserEvent('delete'));

export class CodeEditor {
  readonly view: EditorView;
  private readonly display = new Compartment();
  private readonly status = new Compartment();
  private readonly writable = new Compartment();

  constructor(
    host: HTMLElement,
    private readonly hooks: EditorHooks,
  ) {
    const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
    this.view = new EditorView({ parent: root as unknown as Element, root, state: this.stateOf('', '', false) });
  }

  /** Another text: its own history, its own place. */
  open(text: string, path: string, readOnly: boolean): void {
    this.view.setState(this.stateOf(text, path, readOnly));
  }

  keptState(): EditorState {
    return this.view.state;
  }

  restore(state: EditorState): void {
    this.view.setState(state);
  }

  /** Changes the text where it differs, as one step that can be undone: what is in sight stays. */
  replace(text: string): void {
    const { doc, selection } = this.view.state;
    if (doc.toString() === text) return;
    const after = this.view.state.toText(text);
    this.view.dispatch({ ...textChanges(doc, after, selection.main.head), annotations: fromOutside.of(true) });
  }

  /** Lines [from, to) become these, as one step that can be undone by itself. */
  replaceLines(from: number, to: number, lines: readonly string[]): void {
    const { doc } = this.view.state;
    const begin = from > doc.lines ? doc.length : doc.line(Math.max(from, 1)).from;
    const end = to > doc.lines ? doc.length : doc.line(Math.max(to, 1)).from;
    const text = lines.map((line) => `${line}\n`).join('');
    // Behind a last line without its end.
    const gap = from > doc.lines && doc.length > 0 && !doc.toString().endsWith('\n') ? '\n' : '';
    this.view.dispatch({
      changes: { from: begin, to: end, insert: gap + text },
      annotations: isolateHistory.of('full'),
    });
  }

  undo(): void {
    undo(this.view);
  }

  redo(): void {
    redo(this.view);
  }

  /** `head`: what is read from there on stands at the top; the rest in the middle, below whole lines. */
  goTo(line: number, column = 1, head = false): void {
    const { doc } = this.view.state;
    const at = doc.line(Math.min(Math.max(line, 1), doc.lines));
    const anchor = Math.min(at.from + Math.max(column - 1, 0), at.to);
    const { defaultLineHeight, scrollDOM } = this.view;
    const above = head ? 0 : Math.floor(scrollDOM.clientHeight / defaultLineHeight / 2);
    const yMargin = above * defaultLineHeight + this.leading();
    this.view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: 'start', yMargin }) });
  }

  /** Letters begin below the top of their line; that is what the view scrolls to. */
  private leading(): number {
    const letter = this.view.coordsAtPos(this.view.viewport.from);
    return letter ? (this.view.defaultLineHeight - (letter.bottom - letter.top)) / 2 : 0;
  }

  line(): number {
    return this.view.state.doc.lineAt(this.view.state.selection.main.head).number;
  }

  /** The operand, symbol or block at a place, as it is written. */
  wordAt(position: number): string {
    const line = this.view.state.doc.lineAt(position);
    const before = this.view.state.sliceDoc(0, line.from);
    const state = initialState();
    for (const text of before.split('\n').slice(0, -1)) tokenizeLine(text, state);
    const column = position - line.from;
    const words = tokenizeLine(line.text, state).filter((token) => token.from <= column && column <= token.to);
    return words.find((token) => operandKinds.has(token.kind))?.text ?? '';
  }

  /** Puts a word in place of the selection. */
  insert(text: string): void {
    this.view.dispatch(this.view.state.replaceSelection(text));
    this.view.focus();
  }

  complete(): void {
    this.view.focus();
    startCompletion(this.view);
  }

  showProblems(problems: readonly Problem[]): void {
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics(this.view.state.doc, problems)));
  }

  showDisplay(setting: DisplaySetting): void {
    this.view.dispatch({ effects: this.display.reconfigure(displaySetting.of(setting)) });
  }

  showColumns(columns: readonly string[] | null): void {
    this.view.dispatch({ effects: this.status.reconfigure(columns ? statusDisplay(columns) : []) });
  }

  showStatus(rows: readonly StatusRow[] | null): void {
    this.view.dispatch({ effects: setStatus.of(rows) });
  }

  showValues(values: OperandValues): void {
    this.view.dispatch({ effects: setOperandValues.of(values) });
  }

  showBreakpoints(lines: readonly number[]): void {
    this.view.dispatch({ effects: setBreakpoints.of(lines) });
  }

  showHalt(line: number | null): void {
    this.view.dispatch({ effects: setHaltLine.of(line) });
  }

  showFailed(line: number | null): void {
    this.view.dispatch({ effects: setFailedLine.of(line) });
  }

  destroy(): void {
    this.view.destroy();
  }

  private stateOf(doc: string, path: string, readOnly: boolean): EditorState {
    return EditorState.create({ doc, extensions: this.extensions(path, readOnly) });
  }

  private extensions(path: string, readOnly: boolean): Extension {
    return [
      breakpointGutter(this.hooks.breakpoints),
      lineNumbers(),
      highlightActiveLineGutter(),
      highlightActiveLine(),
      history(),
      drawSelection(),
      bracketMatching(),
      closeBrackets(),
      indentUnit.of('      '),
      search({ top: false }),
      highlightSelectionMatches(),
      // So that the last block can stand at the top as well.
      scrollPastEnd(),
      autocompletion({ override: [completionSource(this.hooks.catalogue)], icons: false }),
      supportFor(path, readOnly),
      this.display.of([]),
      symbolicDisplay,
      operandHover(this.hooks),
      operandValueDisplay(this.hooks.sighted),
      statusField,
      this.status.of([]),
      this.writable.of(EditorState.readOnly.of(readOnly)),
      EditorView.contentAttributes.of({ 'aria-label': this.hooks.label, spellcheck: 'false', tabindex: '0' }),
      keymap.of([
        ...this.hooks.keys,
        { key: 'Mod-g', run: gotoLine, preventDefault: true },
        ...closeBracketsKeymap,
        ...completionKeymap,
        ...searchKeymap,
        ...historyKeymap,
        ...defaultKeymap,
        indentWithTab,
      ]),
      codeTheme,
      phrases(),
      EditorView.updateListener.of((update) => {
        const own = update.transactions.some((transaction) => transaction.annotation(fromOutside));
        if (update.docChanged && !own) this.hooks.edited(update.state.doc.toString(), isTyped(update));
        if (update.selectionSet || update.docChanged)
          this.hooks.moved(update.state.doc.lineAt(update.state.selection.main.head).number);
      }),
    ];
  }
}
