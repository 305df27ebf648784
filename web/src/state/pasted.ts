// A table from the clipboard: a line is a row, tabs divide its columns, as spreadsheets write it.

/** Not a single text, which is typed. */
export const isTable = (text: string): boolean => /[\t\n]/.test(text.trim());

export const cellsOf = (text: string): string[][] =>
  text
    .split(/\r?\n/)
    .filter((line) => line.trim())
    .map((line) => line.split('\t').map((cell) => cell.trim()));

/** Rows in place of the one at `index` if it is `replaced`, else below it. */
export const pastedInto = <T>(rows: readonly T[], index: number, replaced: boolean, more: readonly T[]): T[] => [
  ...rows.slice(0, replaced ? index : index + 1),
  ...more,
  ...rows.slice(index + 1),
];
