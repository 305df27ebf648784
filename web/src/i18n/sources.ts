// For the tests: what the program's own sources say. Not part of the page.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));
export const read = (path: string): string => readFileSync(join(root, path), 'utf8');

const piece = /"((?:[^"\\\n]|\\.)*)"/g;
const plain = (text: string) =>
  [...text.matchAll(piece)].map((one) => one[1]!.replace(/\\[nrt]/g, ' ').replace(/\\(.)/g, '$1')).join('');

// A raw string, strings behind each other, a comment, a character: whichever begins first.
const tokens =
  /R"\(([\s\S]*?)\)"|("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)|\/\/[^\n]*|#include[^\n]*|'(?:\\.|[^'\\\n])'/g;

/** The string literals of a C++ source; those that stand behind each other are one. */
export const literals = (path: string): string[] =>
  [...read(path).matchAll(tokens)].flatMap(([, raw, strings]) => (strings ? [plain(strings)] : raw ? [raw] : []));

/** Code to English text of src/ground/base/problems.inc. */
export function problemTexts(): Record<string, string> {
  const rows = read('src/ground/base/problems.inc').matchAll(/PROBLEM\((P\d{4}), \w+, ((?:"(?:[^"\\]|\\.)*"\s*)+)\)/g);
  return Object.fromEntries([...rows].map((row) => [row[1]!, plain(row[2]!)]));
}

/** The folder of a module, in whichever wing it is. */
function folderOf(module: string): string {
  const wing = readdirSync(join(root, 'src')).find((one) => existsSync(join(root, 'src', one, module)));
  return `src/${wing}/${module}`;
}

/** The sources of a module. */
export function sourcesOf(module: string): string[] {
  const folder = folderOf(module);
  return readdirSync(join(root, folder))
    .filter((name) => /\.(?:cpp|h|inc)$/.test(name))
    .map((name) => `${folder}/${name}`);
}

/** The projects below a folder, by their path in it. */
export function projectsBelow(folder: string, below = ''): string[] {
  return readdirSync(join(root, folder, below), { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .flatMap((entry) => {
      const id = below ? `${below}/${entry.name}` : entry.name;
      const names = readdirSync(join(root, folder, id));
      return names.includes('merker.toml') ? [id] : projectsBelow(folder, id);
    });
}
