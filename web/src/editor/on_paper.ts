// What of a source is printed: the block of the cursor as STEP 7 does it, the whole file where it is at none.
import type { BlockOutline } from './outline';

/** The comments that stand directly above a block belong to it. */
function firstLine(lines: readonly string[], block: BlockOutline): number {
  let line = block.line;
  while (line > 1 && /^\s*\/\//.test(lines[line - 2]!)) line--;
  return line;
}

export function onPaper(path: string, text: string, block?: BlockOutline): { title: string; text: string } {
  if (!block) return { title: path, text };
  const lines = text.split('\n');
  const title = [block.name, block.title].filter(Boolean).join(' ');
  return { title: `${path}: ${title}`, text: lines.slice(firstLine(lines, block) - 1, block.end).join('\n') };
}
