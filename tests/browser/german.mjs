// A project in German, and what of a page is English.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './harness.mjs';

const SETTINGS = `[project]
name = "Probe"

[cpu]
model = "314C-2 PtP"

[[module]]
slot = 1
type = "PS 307 5A"
[[module]]
slot = "2.2"
[[module]]
slot = 4
type = "6ES7 321-7BH01-0AB0"
diagnostics = true
[[module]]
slot = 5
type = "6ES7 331-7KF02-0AB0"
diagnostics = true
range = "4..20mA"
[[module]]
slot = 6
type = "6ES7 332-5HD01-0AB0"
[[module]]
slot = 7
type = "FM 350-1"
[[plant]]
name = "Aufzug"
kind = "lift"
[[plant]]
name = "Band"
kind = "sorting plant"
`;

const PROGRAM = `ORGANIZATION_BLOCK OB 1
TITLE = Hauptprogramm
BEGIN
NETWORK
TITLE = Fehler auf Wunsch
      U     M 20.0;
      SPBN  M001;
      AUF   DB 99;
M001: U     M 20.1;
      SPBN  M002;
      CALL  SFC 46;
M002: NOP   0;
END_ORGANIZATION_BLOCK
`;

const SYMBOLS = `"Anforderung"  M 20.0  BOOL  // Zugriff auf einen DB, der fehlt
"Halt"  M 20.1  BOOL  // Anforderung STOP
`;

/** Writes the project below a folder. */
export function germanProject(folder) {
  const project = join(folder, 'probe');
  mkdirSync(project);
  const files = { 'merker.toml': SETTINGS, 'haupt.awl': PROGRAM, 'symbole.sym': SYMBOLS };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(project, name), text);
  return project;
}

/** The sources that the conformance tests refuse: [name, text]. */
export function refusedSources() {
  const folder = join(root, 'tests/conformance/rejected');
  const names = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith('.awl'));
  return names.sort().map((name) => [name.replaceAll('/', '_'), readFileSync(join(folder, name), 'latin1')]);
}

// Words of English sentences that no German text has, no name of an instruction, option or file.
const WORDS = /\ba [A-Z]|\b(?:[Tt]h(?:e|is|ese|ere)|is|are|not|and|or|of|with|by|has|have|needs|must|cannot|can|from|for|which|expected|missing|exceeded|loaded|error|block|value|outside|possible|between|memory|restart|stuck|module|wire|unknown|at most|[Ii]t)\b/;

/** The English that a reader of the page meets: texts and names of what stands in `scope`, without sources and names of files. */
export async function english(page, scope = 'body') {
  const texts = await page.locator(scope).first().evaluate((top) => {
    const found = [];
    const skip = '.cm-editor, .mono, option, code, script, style, .place, nav';
    const walker = document.createTreeWalker(top, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
    for (let node = walker.currentNode; node; node = walker.nextNode()) {
      const element = node.nodeType === Node.TEXT_NODE ? node.parentElement : node;
      if (!element || element.closest(skip)) continue;
      if (node.nodeType === Node.TEXT_NODE) found.push(node.textContent);
      else for (const name of ['aria-label', 'title', 'placeholder']) found.push(element.getAttribute(name) ?? '');
    }
    return found.map((text) => text.trim()).filter(Boolean);
  });
  return [...new Set(texts)].filter((text) => WORDS.test(text.replace(/„[^“]*“|"[^"]*"|\(tab\)|\[\[\w+\]\]|\b[A-Z_]+\b/g, '')));
}
