// Program status beside the text (S7-EDIT-21): what the CPU had after each statement, as columns at the right edge.
import { Facet, StateEffect, StateField, type Extension } from '@codemirror/state';
import { EditorView, gutter, GutterMarker, showPanel, type Panel } from '@codemirror/view';
import { language } from '../i18n';

export interface StatusColumn {
  id: string;
  title: string;
  /** If it is called something else there. */
  english?: string;
  width: number; // characters
}

/** In the order of the rows of a status event, behind the line number. */
export const statusColumns: readonly StatusColumn[] = [
  { id: 'vke', title: 'VKE', english: 'RLO', width: 4 },
  { id: 'sta', title: 'STA', width: 4 },
  { id: 'or', title: 'OR', width: 3 },
  { id: 'akku1', title: 'AKKU 1', english: 'ACCU 1', width: 9 },
  { id: 'akku2', title: 'AKKU 2', english: 'ACCU 2', width: 9 },
  { id: 'ar1', title: 'AR1', width: 10 },
  { id: 'ar2', title: 'AR2', width: 10 },
  { id: 'stw', title: 'STW', width: 5 },
  { id: 'db', title: 'DB', width: 5 },
  { id: 'di', title: 'DI', width: 5 },
];
export const titleOf = ({ title, english = title }: StatusColumn): string =>
  language.value === 'de' ? title : english;
export const standardColumns = ['vke', 'sta', 'akku1'];

/** Behind the columns: of a CALL what its operands held, by parameter; of S, R, FP and FN a local bit, by its name. */
export type StatusRow = [line: number, ...values: (string | number | Record<string, string>)[]];

/** A machine without address registers leaves theirs empty in each row. */
export const unusedColumns = (rows: readonly StatusRow[]): string[] =>
  statusColumns.filter((_, index) => rows.every((row) => row[index + 1] === '')).map((column) => column.id);

type StatusLines = ReadonlyMap<number, readonly string[]>;

/** null: no status is shown; an empty list: shown, but the block does not run. */
export const setStatus = StateEffect.define<readonly StatusRow[] | null>();

export const statusField = StateField.define<StatusLines | null>({
  create: () => null,
  update: (value, transaction) => {
    for (const effect of transaction.effects)
      if (effect.is(setStatus))
        value = effect.value && new Map(effect.value.map(([line, ...values]) => [line, values.map(String)]));
    return value;
  },
});

export const shownColumns = Facet.define<readonly string[], readonly string[]>({
  combine: (values) => values[0] ?? standardColumns,
});

class StatusMarker extends GutterMarker {
  constructor(readonly cells: readonly { text: string; column: StatusColumn }[]) {
    super();
  }
  override eq(other: StatusMarker): boolean {
    return (
      this.cells.length === other.cells.length &&
      this.cells.every(
        (cell, index) => cell.text === other.cells[index]!.text && cell.column === other.cells[index]!.column,
      )
    );
  }
  override toDOM(): HTMLElement {
    return row(this.cells);
  }
}

function row(cells: readonly { text: string; column: StatusColumn }[]): HTMLElement {
  const element = document.createElement('div');
  element.className = 'cm-status-row';
  for (const { text, column } of cells) {
    const cell = element.appendChild(document.createElement('span'));
    cell.className = `cm-status-cell cm-status-${column.id}${text === '1' ? ' cm-status-one' : ''}`;
    cell.style.width = `${column.width}ch`;
    cell.textContent = text;
  }
  return element;
}

const chosen = (columns: readonly string[]): { column: StatusColumn; index: number }[] =>
  statusColumns.map((column, index) => ({ column, index })).filter(({ column }) => columns.includes(column.id));

const columnsOf = (view: EditorView) => chosen(view.state.facet(shownColumns));

const statusGutter = gutter({
  class: 'cm-status-gutter',
  side: 'after',
  lineMarker: (view, block) => {
    const values = view.state.field(statusField)?.get(view.state.doc.lineAt(block.from).number);
    return values
      ? new StatusMarker(columnsOf(view).map(({ column, index }) => ({ text: values[index] ?? '', column })))
      : null;
  },
  lineMarkerChange: (update) =>
    update.startState.field(statusField) !== update.state.field(statusField) ||
    update.startState.facet(shownColumns) !== update.state.facet(shownColumns),
  initialSpacer: (view) => new StatusMarker(columnsOf(view).map(({ column }) => ({ text: '', column }))),
});

// The heads of the columns, in line with them whatever the scroll bar takes.
function header(view: EditorView): Panel {
  const dom = document.createElement('div');
  dom.className = 'cm-status-head';
  const show = (): void =>
    dom.replaceChildren(row(columnsOf(view).map(({ column }) => ({ text: titleOf(column), column }))));
  const place = (): void => {
    dom.style.paddingRight = `${view.scrollDOM.offsetWidth - view.scrollDOM.clientWidth}px`;
  };
  show();
  return {
    dom,
    top: true,
    mount: place,
    update: (update) => {
      if (update.startState.facet(shownColumns) !== update.state.facet(shownColumns)) show();
      if (update.geometryChanged) place();
    },
  };
}

export const statusDisplay = (columns: readonly string[]): Extension => [
  shownColumns.of(columns),
  statusGutter,
  showPanel.of(header),
];
