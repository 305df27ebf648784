// From row to row of the table of variables by keys.

export type Field = 'operand' | 'modify';
export interface Target {
  row: number;
  field: Field;
}

type Key = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'altKey' | 'shiftKey' | 'metaKey'>;

/** Where a key leads from this place in a table of so many rows; undefined: it is none of these keys. */
export function rowTarget(event: Key, { row, field }: Target, rows: number): Target | undefined {
  if (event.altKey || event.shiftKey || event.metaKey) return undefined;
  const to = event.ctrlKey
    ? { Home: 0, End: rows - 1 }[event.key]
    : { ArrowUp: row - 1, ArrowDown: row + 1 }[event.key];
  return to === undefined ? undefined : { row: Math.min(Math.max(to, 0), rows - 1), field };
}
