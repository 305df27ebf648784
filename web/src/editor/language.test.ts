import { EditorState } from '@codemirror/state';
import { ensureSyntaxTree } from '@codemirror/language';
import { expect, it } from 'vitest';
import { awlSupport } from './language';

it('marks the words of a source', () => {
  const text = 'FUNCTION FC 1 : VOID\nTITLE = My U E 0.0\nBEGIN\nNETWORK\nM1: U E 0.0; // why\n';
  const state = EditorState.create({ doc: text, extensions: awlSupport() });
  const seen: string[] = [];
  ensureSyntaxTree(state, text.length)!.iterate({
    enter: (node) => {
      if (!node.node.firstChild) seen.push(`${node.name} ${text.slice(node.from, node.to)}`);
    },
  });
  const join = seen.join('|');
  expect(join).toContain('FUNCTION');
  expect(join).toMatch(/\bMy U E 0\.0/);
  expect(join).toContain('M1:');
  expect(seen.some((entry) => entry.endsWith(' // why'))).toBe(true);
  expect(seen.some((entry) => entry.endsWith(' U'))).toBe(true);
});
