// The German of what the program says in English. As in gettext the English text is the key; problems have their code.
// A place {} takes what stood in the English text; what is itself a phrase of several words is translated there, and at
// {~} a single word too (not at {}: a symbol may be called "counter"). {1} is the place of the second argument.

const files = import.meta.glob<Record<string, string>>('./german/*.json', { eager: true, import: 'default' });
const tablesOf = (wanted: (path: string) => boolean): Record<string, string> =>
  Object.assign({}, ...Object.entries(files).map(([path, table]) => (wanted(path) ? table : {})));
const ofProblem = (path: string) => path.includes('/problems-');

const problems = tablesOf(ofProblem);
const phrases = tablesOf((path) => !ofProblem(path));
export const tables = { problems, phrases };

const place = /\{(\d*)(~?)\}/g;

function fill(pattern: string, values: readonly string[], inner: (value: string, word: boolean) => string): string {
  let next = 0;
  return pattern.replace(place, (_, index: string, word: string) => {
    const value = values[index === '' ? next++ : Number(index)] ?? '';
    return inner(value, word === '~');
  });
}

interface Pattern {
  english: RegExp;
  german: string;
  weight: number; // letters of its own: the longer pattern says more
  reason: boolean; // "{}: it is encrypted": what stands before is a name, whatever words it has
}
const quoted = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
const patterns: Pattern[] = Object.entries(phrases)
  .filter(([english]) => english.includes('{}'))
  .map(([english, german]) => ({
    english: new RegExp(`^${english.split('{}').map(quoted).join('(.+?)')}$`),
    german,
    weight: english.length,
    reason: /: [^{}]+$/.test(english),
  }))
  .sort((a, b) => b.weight - a.weight);

const part = (value: string, word: boolean): string => (word || value.trim().includes(' ') ? phrase(value) : value);

const reasons = patterns.filter(({ reason }) => reason);

function matched(text: string, some: readonly Pattern[]): string | undefined {
  for (const { english, german } of some) {
    const values = english.exec(text)?.slice(1);
    if (values) return fill(german, values, part);
  }
  return undefined;
}

/** "reason: detail: place" is told part by part, the longest known beginning first. */
function chain(text: string): string | undefined {
  for (let at = text.lastIndexOf(': '); at > 0; at = text.lastIndexOf(': ', at - 1)) {
    const head = text.slice(0, at);
    const german = phrase(head);
    if (german !== head) return `${german}: ${part(text.slice(at + 2), false)}`;
  }
  return undefined;
}

/** The German of a text of the program; the text itself where there is none. */
export function phrase(text: string): string {
  if (Object.hasOwn(phrases, text)) return phrases[text]!;
  return matched(text, reasons) ?? chain(text) ?? matched(text, patterns) ?? text;
}

/** The German of a problem: its code's text with its arguments; the English sentence where there is none. */
export function problemText(code: string, values: readonly string[] | undefined, english: string): string {
  const pattern = problems[code];
  return pattern === undefined || values === undefined ? english : fill(pattern, values, part);
}
