// What differs between two programs: blocks by their code and text, symbols by name, modules by place.
import type { BlockText, Rack, Requests, Slot, SymbolRow } from '../connection/protocol';
import { compareIds } from '../editor/block_tree';

export type Look = Requests['projects.look']['result'];
/** `text`: the same code from another source, a comment for example. */
export type State = 'same' | 'text' | 'different' | 'onlyLeft' | 'onlyRight';

export interface BlockPair {
  id: string;
  state: State;
  left?: BlockText;
  right?: BlockText;
}
export interface RowPair {
  key: string;
  state: State;
  /** One text per column; empty on a side that has no such row. */
  left: string[];
  right: string[];
}

function pairs<T>(left: readonly T[], right: readonly T[], keyOf: (one: T) => string): [string, T?, T?][] {
  const rights = new Map(right.map((one) => [keyOf(one), one]));
  const lefts = new Map(left.map((one) => [keyOf(one), one]));
  return [...new Set([...lefts.keys(), ...rights.keys()])].map((key) => [key, lefts.get(key), rights.get(key)]);
}

/** Trailing space and empty lines at the end mean nothing. */
const plain = (text: string): string => text.replace(/[ \t]+$/gm, '').trimEnd();

function blockState(left?: BlockText, right?: BlockText): State {
  if (!left) return 'onlyRight';
  if (!right) return 'onlyLeft';
  if (left.code !== right.code || left.checksum !== right.checksum) return 'different';
  return left.source && right.source && plain(left.source) !== plain(right.source) ? 'text' : 'same';
}

export const compareBlocks = (left: Look, right: Look): BlockPair[] =>
  pairs(left.blocks, right.blocks, ({ id }) => id)
    .map(([id, a, b]) => ({ id, state: blockState(a, b), left: a, right: b }))
    .sort((a, b) => compareIds(a.id, b.id));

function rowPairs(left: Map<string, string[]>, right: Map<string, string[]>): RowPair[] {
  return pairs([...left.keys()], [...right.keys()], (key) => key).map(([key]) => {
    const a = left.get(key);
    const b = right.get(key);
    const state = !a ? 'onlyRight' : !b ? 'onlyLeft' : a.join('\n') === b.join('\n') ? 'same' : 'different';
    return { key, state, left: a ?? [], right: b ?? [] };
  });
}

/** By their names, as everything in a program uses them. */
export function compareSymbols(left: Look, right: Look): RowPair[] {
  const rows = (list: readonly SymbolRow[]) =>
    new Map(list.map(({ symbol, operand, type, comment }) => [symbol, [operand, type, comment]]));
  return rowPairs(rows(left.symbols), rows(right.symbols)).sort((a, b) => a.key.localeCompare(b.key));
}

const range = (what: string, area: { first: number; bytes: number } | null): string =>
  area ? `${what} ${area.first}…${area.first + area.bytes - 1}` : '';

/** How what a module has is said. */
export interface Words {
  module: (name: string) => string;
  property: (property: [string, string]) => string;
}
const asGiven: Words = { module: (name) => name, property: (property) => property.join(': ') };

/** Of two modules what only one has; of equal ones, or without another, all. */
function ownProperties(slot: Slot, other: Slot | undefined): [string, string][] {
  const theirs = new Set(other?.properties.map((one) => one.join('\n')));
  const own = slot.properties.filter((one) => !theirs.has(one.join('\n')));
  return other && sameProperties(slot, other) ? slot.properties : own;
}
const sameProperties = (a: Slot, b: Slot): boolean => JSON.stringify(a.properties) === JSON.stringify(b.properties);

/** There is one CPU, wherever it stands. */
const placed = (racks: readonly Rack[]) =>
  new Map(
    racks.flatMap(({ rack, slots }) =>
      slots.map((slot): [string, Slot] => [slot.kind === 'cpu' ? 'CPU' : `${rack}/${slot.slot}`, slot]),
    ),
  );

/** By rack and slot: module, addresses, parameters; of those what differs. */
export function compareModules(left: Look, right: Look, words = asGiven): RowPair[] {
  const [lefts, rights] = [placed(left.racks), placed(right.racks)];
  const rows = (some: Map<string, Slot>, others: Map<string, Slot>) =>
    new Map(
      [...some].map(([key, slot]): [string, string[]] => [
        key,
        [
          [words.module(slot.name), slot.order].filter(Boolean).join(' '),
          [range('E', slot.inputs), range('A', slot.outputs)].filter(Boolean).join(', '),
          ownProperties(slot, others.get(key)).map(words.property).join('; '),
        ],
      ]),
    );
  return rowPairs(rows(lefts, rights), rows(rights, lefts)).sort((a, b) =>
    a.key.localeCompare(b.key, 'en', { numeric: true }),
  );
}

/** A listing of machine code without its addresses and words, which the first difference moves or changes from there on. */
const statements = (code: string): string => code.replace(/^(?:[0-9A-F]{4}: (?:[0-9A-F]+ ?)+ +| {23})/gm, '');

/** The two texts of a block that show its difference: the sources, unless only the code is known or differs. */
export function textsOf(pair: BlockPair, code: boolean): { left: string; right: string; code: boolean } {
  const { left, right } = pair;
  const sources = (left ? left.source !== '' : true) && (right ? right.source !== '' : true);
  const differ = !left || !right || pair.state === 'same' || plain(left.source) !== plain(right.source);
  const ofCode = code || !sources || !differ;
  const text = (one?: BlockText) => (one ? (code ? one.code : ofCode ? statements(one.code) : one.source) : '');
  return { left: text(left), right: text(right), code: ofCode };
}
