// The same text as somebody else has left it: only what differs changes, so that what is in sight and the cursor stay.
import { presentableDiff } from '@codemirror/merge';
import type { Text, TransactionSpec } from '@codemirror/state';

/** Effort; texts with more differences are changed in larger pieces. */
const SCAN_LIMIT = 500;

/** What makes `text` of `doc`; the cursor stays at its word, or in its line where that has changed. */
export function textChanges(doc: Text, text: Text, head: number): Pick<TransactionSpec, 'changes' | 'selection'> {
  const parts = presentableDiff(doc.toString(), text.toString(), { scanLimit: SCAN_LIMIT });
  const around = parts.find(({ fromA, toA }) => fromA < head && head < toA);
  return {
    changes: parts.map(({ fromA, toA, fromB, toB }) => ({ from: fromA, to: toA, insert: text.slice(fromB, toB) })),
    ...(around && {
      selection: { anchor: sameLine(doc, head, text, lineOf(text, around.fromB) - lineOf(doc, around.fromA)) },
    }),
  };
}

const lineOf = (text: Text, at: number): number => text.lineAt(at).number;

/** The place in the line of this number, moved by so many lines, as far behind its beginning. */
function sameLine(before: Text, at: number, after: Text, moved: number): number {
  const { number, from } = before.lineAt(at);
  const line = after.line(Math.min(number + moved, after.lines));
  return Math.min(line.from + at - from, line.to);
}
