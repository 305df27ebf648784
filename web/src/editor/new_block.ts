// The text a new block begins with.

const keywords: Record<string, string> = {
  OB: 'ORGANIZATION_BLOCK',
  FB: 'FUNCTION_BLOCK',
  FC: 'FUNCTION',
  DB: 'DATA_BLOCK',
};

/** "fc1" becomes "FC 1"; null if it is no block that can be written. */
export function blockId(text: string): string | null {
  const [, kind, number] = /^\s*(OB|FB|FC|DB)\s*(\d{1,5})\s*$/i.exec(text) ?? [];
  return kind ? `${kind.toUpperCase()} ${Number(number)}` : null;
}

/** What a data block can be made of: "fb1", "UDT 2", a symbol in quotation marks; null if it is nothing like it. */
export function typeName(text: string): string | null {
  const [, kind, number] = /^\s*(FB|SFB|UDT)\s*(\d{1,5})\s*$/i.exec(text) ?? [];
  if (kind) return `${kind.toUpperCase()} ${Number(number)}`;
  return /^\s*"[^"]+"\s*$/.test(text) ? text.trim() : null;
}

const code = (head: string, end: string, sections = ''): string => `${head}
TITLE =
VERSION : 0.1
${sections}BEGIN
NETWORK
TITLE =

${end}
`;

export function blockText(id: string, instanceOf = ''): string {
  const kind = id.slice(0, 2);
  const keyword = keywords[kind]!;
  if (kind === 'DB')
    return instanceOf
      ? `DATA_BLOCK ${id} ${instanceOf}\nBEGIN\nEND_DATA_BLOCK\n`
      : `DATA_BLOCK ${id}\nSTRUCT\n  Value : INT ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n`;
  const sections = kind === 'FB' ? 'VAR_INPUT\nEND_VAR\n' : '';
  return code(kind === 'FC' ? `${keyword} ${id} : VOID` : `${keyword} ${id}`, `END_${keyword}`, sections);
}
