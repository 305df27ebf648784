// Variable tables as text files of the project, one row a line: operand ; format ; modify value
// docs/formats/variable-table.md

export interface Row {
  operand: string;
  format: string;
  modify: string;
}

const HEAD = '// operand ; format ; modify value';

/** `triggers`: a line about them, or none. */
export function printTable(rows: Row[], triggers = ''): string {
  const lines = rows
    .filter((row) => row.operand.trim())
    .map((row) => [row.operand, row.format, row.modify].join(' ; ').replace(/[ ;]+$/, ''));
  return [HEAD, ...(triggers ? [triggers] : []), ...lines, ''].join('\n');
}

/** Lines that begin with // and empty ones are skipped. A semicolon in quotation marks belongs to the operand. */
export function parseTable(text: string): Row[] {
  return text
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter((line) => line && !line.startsWith('//'))
    .map((line) => {
      const [operand = '', format = '', ...modify] =
        line.match(/(?:"[^"]*"|'[^']*'|[^;])+|;/g)?.reduce(fields, ['']) ?? [];
      return { operand: operand.trim(), format: format.trim() || 'AUTO', modify: modify.join(';').trim() };
    });
}

function fields(list: string[], part: string): string[] {
  if (part === ';') return [...list, ''];
  return [...list.slice(0, -1), list[list.length - 1] + part];
}

/** A path for a table that a user named: "press 1" is press 1.vat. */
export function tablePath(name: string): string {
  const plain = name.trim().replace(/[\\/:*?"<>|]+/g, '-');
  return plain.toLowerCase().endsWith('.vat') ? plain : `${plain}.vat`;
}
