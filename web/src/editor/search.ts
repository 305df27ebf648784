// Finding a text in all files of the project, also a part of a word, and putting another in its place.

export interface Query {
  text: string;
  matchCase: boolean;
  wholeWord: boolean;
}

export interface Hit {
  file: string;
  /** From 1. */
  line: number;
  /** From 0, in the line. */
  from: number;
  to: number;
  /** The whole line. */
  text: string;
}

const letter = /[\p{L}\p{N}_]/u;

/** The places in this text, in their order. An empty query is nowhere. */
export function find(file: string, text: string, { text: wanted, matchCase, wholeWord }: Query): Hit[] {
  if (wanted === '') return [];
  const fold = (one: string): string => (matchCase ? one : lower(one));
  const needle = fold(wanted);
  const hits: Hit[] = [];
  text.split('\n').forEach((whole, index) => {
    const line = whole.replace(/\r$/, '');
    const folded = fold(line);
    for (let from = folded.indexOf(needle); from >= 0; from = folded.indexOf(needle, from + needle.length)) {
      const to = from + needle.length;
      if (!wholeWord || isWord(line, from, to)) hits.push({ file, line: index + 1, from, to, text: line });
    }
  });
  return hits;
}

/** Letter by letter: no other length, so that places stay what they are. */
const lower = (text: string): string =>
  text.toLowerCase().length === text.length
    ? text.toLowerCase()
    : [...text].map((one) => (one.toLowerCase().length === one.length ? one.toLowerCase() : one)).join('');

const isWord = (line: string, from: number, to: number): boolean =>
  !letter.test(line.charAt(from - 1)) && !letter.test(line.charAt(to));

/** The line as it will be. */
export const replacedLine = (hit: Hit, replacement: string): string =>
  hit.text.slice(0, hit.from) + replacement + hit.text.slice(hit.to);

/** `hits` are places of this very text, in their order; ends of lines stay as they are. */
export function replaceAt(text: string, hits: readonly Hit[], replacement: string): string {
  const lines = text.split('\n');
  for (const hit of [...hits].reverse()) {
    const line = lines[hit.line - 1]!;
    lines[hit.line - 1] = line.slice(0, hit.from) + replacement + line.slice(hit.to);
  }
  return lines.join('\n');
}

/** What stands before and behind a place, short enough for one row. */
export function around({ text, from, to }: Hit, room = 60): [before: string, found: string, behind: string] {
  const begin = Math.max(0, from - room);
  const before = (begin > 0 ? '…' : '') + text.slice(begin, from).replace(/^\s+/, '');
  return [before, text.slice(from, to), text.slice(to, to + 2 * room)];
}

/** Texts about the project, in plain language: nobody means them who renames a symbol. */
export const isProse = (path: string): boolean => /\.(md|txt)$/i.test(path);
