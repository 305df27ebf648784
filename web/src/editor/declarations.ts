// The declaration table changes the text: one row is one line of it (S7-EDIT-01, -02).
import {
  allowedDeclarations,
  declarationText,
  sectionKeyword,
  type BlockOutline,
  type Declaration,
  type DeclarationRow,
} from './outline';

type Fields = Pick<DeclarationRow, 'name' | 'type' | 'initial' | 'comment'>;

export function replaceRow(text: string, row: DeclarationRow, change: Partial<Fields>): string {
  const lines = text.split('\n');
  const indent = '  '.repeat(row.depth);
  lines[row.line - 1] = indent + declarationText({ ...row, ...change });
  return lines.join('\n');
}

export function removeRow(text: string, row: DeclarationRow): string {
  const lines = text.split('\n');
  lines.splice(row.line - 1, 1);
  return lines.join('\n');
}

const order: Declaration[] = ['in', 'out', 'in_out', 'stat', 'temp'];

// Where a new section belongs: behind those that come before it, else before BEGIN.
function sectionLine(block: BlockOutline, declaration: Declaration): number {
  const before = block.sections.filter((section) => order.indexOf(section.declaration) < order.indexOf(declaration));
  if (before.length > 0) return Math.max(...before.map((section) => section.end));
  const first = block.sections[0];
  if (first) return first.line - 1;
  return block.begin > 0 ? block.begin - 1 : block.line;
}

function freeName(block: BlockOutline): string {
  const names = new Set(block.declarations.map((row) => row.name.toUpperCase()));
  let number = 1;
  while (names.has(`VAR${number}`)) number++;
  return `Var${number}`;
}

export function addRow(text: string, block: BlockOutline, declaration: Declaration): string {
  if (!allowedDeclarations(block.keyword).includes(declaration)) return text;
  const lines = text.split('\n');
  const row = declarationText({ name: freeName(block), type: 'BOOL', initial: '', comment: '' });
  const section = block.sections.find((one) => one.declaration === declaration && one.end > 0);
  if (section) lines.splice(section.end - 1, 0, row);
  else lines.splice(sectionLine(block, declaration), 0, sectionKeyword(declaration), row, 'END_VAR');
  return lines.join('\n');
}
