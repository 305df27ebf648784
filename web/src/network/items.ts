// What can be selected in a network: elements (contact, coil, box) and the operands at their pins; and the way from one to
// the next with the arrow keys.
import type { NetworkShape } from '../connection/protocol';
import { rectOf, type Rect } from './geometry';

/** As the server names it (graph/selection.h): by the last statement, a group without brackets by its first one too. */
export interface Place {
  node: number;
  /** NO_PIN: the element itself. */
  pin: number;
  first: number;
}

export const NO_PIN = -1;
export const OWN = 0;

export interface Item extends Place {
  kind: NetworkShape['kind'];
  rect: Rect;
  /** Of the statement, counted from the first line of the network. */
  line: number;
  /** The operand as it stands in the text; undefined: there is none to type. */
  operand: string | undefined;
  /** Which pin takes the operand that is typed while this is selected. */
  field: number;
  /** Line of the statement that loads or transfers it; undefined: it has no value of its own. */
  value: number | undefined;
  /** The value is BCD, as LC gives it. */
  bcd: boolean;
  /** Of the CALL whose operand it is. */
  parameter: string | undefined;
  /** As the operand is declared. */
  type: string | undefined;
  /** Where it is typed. */
  place: Rect;
  /** What stands inside: "", "/", "S", "&". */
  name: string;
  /** A box that calls a block. */
  calls?: boolean;
  /** The pin of a box that has its operand here. */
  of?: PinName | undefined;
}

export interface PinName {
  side: 'inputOf' | 'outputOf';
  pin: string;
  /** Node of the box. */
  box: number;
}

export const same = (a: Place | null, b: Place | null): boolean =>
  a?.node === b?.node && a?.pin === b?.pin && a?.first === b?.first;

export const keyOf = ({ node, pin, first }: Place): string => `${node} ${pin} ${first}`;

/** Not written yet: "??.?", "???". */
export const missing = (operand: string | undefined): boolean => operand?.startsWith('??') ?? false;

const isSymbol = (shape: NetworkShape) => shape.kind === 'contact' || shape.kind === 'coil';

const around = (a: Rect, b: Rect): Rect => {
  const x = Math.min(a.x, b.x);
  const y = Math.min(a.y, b.y);
  return {
    x,
    y,
    width: Math.max(a.x + a.width, b.x + b.width) - x,
    height: Math.max(a.y + a.height, b.y + b.height) - y,
  };
};

const written = (shape: NetworkShape): string => shape.written ?? shape.text ?? '';

/** What has an operand above it: contacts, coils, boxes with a timer, "=" of FUP. A gate has none: it is named by its contact. */
const hasOwn = (shape: NetworkShape) => isSymbol(shape) || (shape.kind === 'frame' && shape.first === undefined);

/** The operand above an element belongs to it; all others are places of their own. */
export function itemsOf(shapes: readonly NetworkShape[]): Item[] {
  const known = shapes.filter((shape) => shape.node !== undefined);
  const owners = new Set(known.filter(hasOwn).map(({ node }) => node));
  const own = new Map(known.filter((one) => one.kind === 'text' && one.pin === OWN).map((one) => [one.node, one]));
  const items: Item[] = [];
  for (const shape of known) {
    const {
      node = -1,
      pin = NO_PIN,
      first = -1,
      kind,
      line = 0,
      text = '',
      value,
      bcd = false,
      type,
      parameter,
    } = shape;
    const rect = rectOf(shape);
    const plain = { node, pin, first, kind, rect, line, value, bcd, type, parameter, place: rect, name: text };
    if (isSymbol(shape)) items.push({ ...plain, ...operandAbove(own.get(node), rect) });
    else if (kind === 'frame') {
      const above = hasOwn(shape) ? own.get(node) : undefined;
      const calls = above !== undefined && shapes.some((one) => one.text === 'EN' && within(shape, one));
      items.push({ ...plain, calls, pin: NO_PIN, name: titleOf(shapes, shape), ...operandAbove(above, rect) });
    } else if ((kind === 'text' || kind === 'field') && pin !== NO_PIN && !(pin === OWN && owners.has(node)))
      items.push({ ...plain, operand: written(shape), field: pin, of: pinOf(shapes, shape) });
  }
  return items;
}

function operandAbove(text: NetworkShape | undefined, rect: Rect): Pick<Item, 'rect' | 'operand' | 'field' | 'place'> {
  if (!text) return { rect, operand: undefined, field: NO_PIN, place: rect };
  const place = rectOf(text);
  return { rect: around(rect, place), operand: written(text), field: OWN, place };
}

/** The wires where branches end, one a group: what is put there stands behind it. */
export function junctionsOf(shapes: readonly NetworkShape[]): Item[] {
  const wires = shapes.filter(({ kind, node }) => kind === 'wire' && node !== undefined).sort((a, b) => a.w - b.w);
  const widest = new Map(wires.map((wire) => [`${wire.node} ${wire.first}`, wire]));
  const nothing = {
    operand: undefined,
    field: NO_PIN,
    value: undefined,
    bcd: false,
    type: undefined,
    parameter: undefined,
    name: '',
  };
  return [...widest.values()].map((wire) => {
    const { node = -1, first = -1, line = 0, kind } = wire;
    const rect = rectOf(wire);
    return { ...nothing, node, pin: NO_PIN, first, kind, rect, line, place: rect };
  });
}

export const itemAt = (shapes: readonly NetworkShape[], place: Place | null): Item | null =>
  [...itemsOf(shapes), ...junctionsOf(shapes)].find((item) => same(item, place)) ?? null;

const within = ({ x, y, w, h }: NetworkShape, at: NetworkShape): boolean =>
  at.kind === 'text' && at.x >= x && at.x + at.w <= x + w && at.y >= y && at.y < y + h;

/** An open pin lies on its name, an operand in its row beside the box; a gate has no names. */
function pinOf(shapes: readonly NetworkShape[], { x, y, w }: NetworkShape): PinName | undefined {
  const away = (one: NetworkShape) => Math.max(one.x - (x + w), x - (one.x + one.w));
  const [box] = shapes
    .filter((one) => one.kind === 'frame' && one.y <= y && y < one.y + one.h)
    .sort((a, b) => away(a) - away(b));
  if (!box) return undefined;
  const isLeft = 2 * x + w < 2 * box.x + box.w;
  const names = shapes.filter((one) => one.y === y && within(box, one)).sort((a, b) => a.x - b.x);
  const pin = names.at(isLeft ? 0 : -1)?.text ?? '';
  return pin ? { side: isLeft ? 'inputOf' : 'outputOf', pin, box: box.node ?? -1 } : undefined;
}

/** The first text inside a frame. */
function titleOf(shapes: readonly NetworkShape[], frame: NetworkShape): string {
  const inside = shapes.filter((one) => within(frame, one));
  return (
    inside.reduce<NetworkShape | undefined>((best, one) => (best && best.y <= one.y ? best : one), undefined)?.text ??
    ''
  );
}

const middleOf = ({ x, y, width, height }: Rect) => ({ x: x + width / 2, y: y + height / 2 });

export type Direction = 'left' | 'right' | 'up' | 'down';

/** How far `to` is, against the direction of the key: Infinity if it lies elsewhere. */
function distance(from: Rect, to: Rect, direction: Direction): number {
  const a = middleOf(from);
  const b = middleOf(to);
  const across = direction === 'left' || direction === 'right';
  const sign = direction === 'left' || direction === 'up' ? -1 : 1;
  const ahead = sign * (across ? b.x - a.x : b.y - a.y);
  const aside = Math.abs(across ? b.y - a.y : b.x - a.x);
  return ahead <= 4 ? Infinity : ahead + (across ? 6 : 1) * aside;
}

/** Along the wire; undefined at the edge of the network. */
export function next(items: readonly Item[], from: Item, direction: Direction): Item | undefined {
  let best: Item | undefined;
  let least = Infinity;
  for (const item of items) {
    const far = distance(from.rect, item.rect, direction);
    if (far < least) [best, least] = [item, far];
  }
  return best;
}

/** From the upper left to the lower right, as it is read. */
export const inOrder = (items: readonly Item[]): Item[] =>
  [...items].sort((a, b) => a.rect.y - b.rect.y || a.rect.x - b.rect.x);

/** The next operand to type: one that is missing, behind this field and then from the beginning. */
export function nextMissing(items: readonly Item[], from: Pick<Item, 'node' | 'field'>): Item | undefined {
  const order = items.filter((item) => missing(item.operand)).sort((a, b) => a.node - b.node || a.field - b.field);
  return order.find(({ node, field }) => node > from.node || (node === from.node && field > from.field)) ?? order[0];
}
