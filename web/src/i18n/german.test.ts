// Everything that the program says has its German: who adds a code, an event or a phrase learns it here.
import { describe, expect, test } from 'vitest';
import { SIGNALS } from '../process/names';
import { examples } from './examples';
import { phrase, problemText, tables } from './phrases';
import { instructions } from './texts/instructions';
import { modules as words } from './texts/modules';
import { unchanged } from './unchanged';
import { literals, problemTexts, projectsBelow, read, sourcesOf } from './sources';

const problems = problemTexts();
const codes = Object.keys(problems);

/** Which arguments a text has places for. */
function places(text: string): number[] {
  let next = 0;
  const found = [...text.matchAll(/\{(\d*)~?\}/g)].map((one) => (one[1] === '' ? next++ : Number(one[1])));
  return [...new Set(found)].sort((a, b) => a - b);
}

describe('problems', () => {
  test('there are some', () => expect(codes.length).toBeGreaterThan(300));
  test.each(codes)('%s has its German with the same places', (code) => {
    expect(tables.problems).toHaveProperty(code);
    expect(places(tables.problems[code]!)).toEqual(places(problems[code]!));
  });
  test('there is no German of a code that is gone', () =>
    expect(Object.keys(tables.problems).filter((code) => !(code in problems))).toEqual([]));
});

test.each(Object.entries(tables.phrases))('"%s" has as many places in German', (english, german) => {
  expect(german).not.toBe('');
  expect(places(german)).toEqual(places(english));
});

// Tables whose every text a person reads.
const told = [
  'src/s7/cpu/event.cpp',
  'src/s7/cpu/error.cpp',
  'src/s7/cpu/asynchronous_errors.cpp',
  'src/tool/monitor/diagnostic_help.cpp',
];
const english = (text: string) => /[a-z]{2,} |^an? | [a-z]{2,}/.test(text.trim());
test.each(told)('%s is told in German', (path) => {
  const texts = literals(path).filter((text) => english(text) && !text.includes('{') && !/^[:,]/.test(text));
  expect(texts.length).toBeGreaterThan(15);
  expect(texts.filter((text) => phrase(text) === text)).toEqual([]);
});

test('the alarms of a SINUMERIK are told in German', () => {
  const rows = [...read('src/s5/softplc/alarms.inc').matchAll(/^ALARM\((\d+), \w+, "([^"]*)", "([^"]*)"/gm)];
  expect(rows.length).toBeGreaterThan(50);
  const texts = rows.map((row) => [`${row[1]} ${row[2]} (${row[3]})`, `${row[1]} ${row[2]}`] as const);
  for (const [text, german] of texts) expect(phrase(text)).toBe(german);
});

// Rows that are nothing but places say what somebody else says.
const notes = [...read('src/tool/importing/notes.inc').matchAll(/^NOTE\(\w+, \w+, "((?:[^"\\]|\\.)*)"\)/gm)]
  .map((row) => row[1]!.replace(/\\(.)/g, '$1').replace(/\{\d\}/g, '{}'))
  .filter((text) => /[a-z]{2}/.test(text));
for (const [, reason] of read('src/tool/importing/report.cpp').matchAll(/return "([a-z][^"]+)";/g))
  notes.push(`{}: ${reason!}`);
test('an import is reported', () => expect(notes.length).toBeGreaterThan(40));
test.each(notes)('the report says in German: %s', (text) => expect(tables.phrases).toHaveProperty([text]));

test('each instruction is explained', () => {
  const ids = [...read('src/s7/mc7/operations.inc').matchAll(/^OPERATION\((\w+)/gm)].map((one) => one[1]!);
  expect(ids.length).toBeGreaterThan(150);
  expect(Object.keys(instructions)).toEqual([...ids, 'CALL']);
});

// What the drawings show by themselves has no name: the stroke of a slider, the boxes on the belt.
const drawn = /^(?:STROKE_|BOX\d|FRONT\d|PUSHED\d)/;
const plants = sourcesOf('plant')
  .map((path) => read(path))
  .flatMap((code) => {
    const kind = /^const Kind k\w+\{"([^"]+)"/m.exec(code)?.[1];
    const signals = [...code.matchAll(/\{"([A-Z][A-Z0-9_]*)", (?:Signal::)?Side::/g)].map((one) => one[1]!);
    return kind ? [[kind, signals.filter((name) => !drawn.test(name))] as const] : [];
  });
test.each(plants)('the plant "%s" has names for its signals', (kind, signals) => {
  expect(signals.length).toBeGreaterThan(1);
  expect(signals.filter((name) => !SIGNALS[kind]?.[name])).toEqual([]);
});

test('each example has its German', () =>
  expect(Object.keys(examples).sort()).toEqual(projectsBelow('examples').sort()));

// Modules whose phrases reach the page, and what of them does not.
const modules = [
  'address',
  'block',
  'catalogue',
  'compilation',
  'cpu',
  'io',
  'project',
  'source',
  'station',
  'step5',
  'step7',
  'workbench',
];
const known = [...Object.keys(tables.phrases), ...Object.values(problems), ...Object.keys(words)];
// What stays as it is: values that a user writes in merker.toml, texts of programs and files, parts that are joined.
const asItIs = new Set<string>(unchanged);
const covered = (text: string) => {
  const bare = text.trim();
  return asItIs.has(bare) || known.some((one) => one.includes(bare)) || phrase(text) !== text;
};
// What only the command line says ('merker bench --why').
const commandLine = (path: string) => path.endsWith('/quiet_reasons.cpp');
test.each(modules)('the phrases of src/%s have their German', (module) => {
  const texts = sourcesOf(module)
    .filter((path) => !commandLine(path))
    .flatMap(literals);
  expect(texts.filter((text) => english(text) && !covered(text))).toEqual([]);
});

describe('a problem', () => {
  test('keeps what stood in it', () =>
    expect(problemText('P0214', ['flag byte', '301', '255', 'CPU 314C-2 PtP'], '')).toBe(
      'Merkerbyte 301 liegt außerhalb von 0..255 der CPU 314C-2 PtP',
    ));
  test('keeps names that are words of the program', () =>
    expect(problemText('P0422', ['counter'], '')).toBe('„counter“ ist zweimal vereinbart'));
  test('is told in English where the program is newer than the page', () => {
    expect(problemText('P9999', ['1'], 'something new')).toBe('something new');
    expect(problemText('P0214', undefined, 'as it was')).toBe('as it was');
  });
});

test.each([
  ['programming error: data block not loaded: DB 7', 'Programmierfehler: Datenbaustein nicht geladen: DB 7'],
  ['module fault, coming: address 256', 'Baugruppe gestört, kommend: Adresse 256'],
  [
    'STOP by programming error (OB 121 not loaded): data block not loaded: DB 7, FC 1 byte 6 (main.awl:12) [16#4562]',
    'STOP durch Programmierfehler (OB 121 nicht geladen): Datenbaustein nicht geladen: DB 7, FC 1 Byte 6 (main.awl:12) [16#4562]',
  ],
  ['STOP: unknown operation code: FFFF', 'STOP: unbekannter Operationscode: FFFF'],
  ['a whole number from 1 to 5', 'eine ganze Zahl von 1 bis 5'],
  ['MW 10', 'MW 10'],
  [
    'cut.zip, from byte 76997 on: it is damaged or cut off; what lies before was read',
    'cut.zip, ab Byte 76997: beschädigt oder abgeschnitten; gelesen wurde, was davor liegt',
  ],
])('%s', (text, german) => expect(phrase(text)).toBe(german));
