import { EditorState, Text } from '@codemirror/state';
import { describe, expect, it } from 'vitest';
import { textChanges } from './text_changes';

const lines = Array.from({ length: 40 }, (_, index) => `      L     MW ${index + 1};`);
const before = Text.of(lines);
const changed = (...of: [number, string][]): Text => {
  const all = [...lines];
  for (const [line, text] of of) all[line - 1] = text;
  return Text.of(all);
};
const applied = (text: Text, head: number) =>
  EditorState.create({ doc: before, selection: { anchor: head } }).update(textChanges(before, text, head));

describe('a text that somebody else has changed', () => {
  it('changes where it differs, and between two such places nothing', () => {
    const text = changed([2, '// the first'], [39, '// the last']);
    const update = applied(text, before.line(20).from + 8);
    expect(update.newDoc.eq(text)).toBe(true);
    expect(update.changes.touchesRange(before.line(3).from, before.line(38).to)).toBe(false);
    expect(update.newSelection.main.head).toBe(text.line(20).from + 8);
  });

  it('leaves the cursor in its line where all around it is other', () => {
    const text = Text.of(['// new', ...changed([20, '#############################']).toJSON()]);
    const update = applied(text, before.line(20).from + 8);
    expect(update.newDoc.eq(text)).toBe(true);
    expect(update.newDoc.lineAt(update.newSelection.main.head).number).toBe(21);
  });

  it('becomes an empty one', () => {
    expect(applied(Text.of(['']), before.length - 1).newDoc.length).toBe(0);
  });
});
