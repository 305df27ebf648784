// Names and values of an answer as rows to show: nested objects become sections of their own.

export type Fact = { name: string; value: string };
export interface Section {
  name: string;
  facts: Fact[];
}

export function sections(answer: Record<string, unknown>, name = ''): Section[] {
  const own: Section = { name, facts: [] };
  const below: Section[] = [];
  for (const [key, value] of Object.entries(answer)) {
    if (isObject(value)) below.push(...sections(value, key));
    else own.facts.push({ name: key, value: print(value) });
  }
  return [...(own.facts.length ? [own] : []), ...below];
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function print(value: unknown): string {
  if (Array.isArray(value)) return value.map(print).join(', ');
  return value === null || value === undefined ? '–' : String(value);
}
