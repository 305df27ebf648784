// The answer of hardware.read, and what of it the picture shows.

export interface Range {
  first: number;
  bytes: number;
}

export interface Terminal {
  text: string;
  operand: string;
  symbol: string;
}

export interface Fault {
  name: string;
  title: string;
  on: boolean;
}

export interface Slot {
  slot: string;
  order: string;
  /** The name in the project, otherwise the type. */
  name: string;
  type: string;
  kind: string;
  /** False: pulled. */
  present: boolean;
  inputs?: Range | null;
  outputs?: Range | null;
  terminals: Terminal[];
  properties: [string, string][];
  leds?: Record<string, string>;
  faults: Fault[];
}

export interface Rack {
  rack: number;
  slots: Slot[];
  /** Slaves of a bus instead: of the CP in the slot `place`, or with that address. */
  bus?: 'asi' | 'profibus';
  place?: string;
}

/** One housing on the rail: a module, or a compact CPU with the submodules that sit in it (2.2, 2.3, …). */
export interface Housing {
  main: Slot;
  parts: Slot[];
}

/** The slot in its rack: rows of other racks are named "1/4". */
export const slotOf = (slot: Slot): string => slot.slot.replace(/^\d+\//, '');

/** What the picture says of it. */
export const title = (rack: Rack) =>
  ({ key: rack.bus ?? 'rack', values: { number: rack.place ?? rack.rack } }) as const;

const plug = (slot: Slot) => slot.slot.split('.')[0]!;

export function housings(rack: Rack): Housing[] {
  const found = new Map<string, Housing>();
  for (const slot of rack.slots) {
    const there = found.get(plug(slot));
    if (there) there.parts.push(slot);
    else found.set(plug(slot), { main: slot, parts: [] });
  }
  return [...found.values()];
}

export const isBit = (operand: string) => /^(?:[EIAQ]) \d+\.\d$/.test(operand);

/** The terminals that have a lamp on the front. */
export const lamps = (slot: Slot) => slot.terminals.filter((terminal) => isBit(terminal.operand));

/** "E 0.0 … 1.7", "PEW 752 … 760": what the module answers to, from its terminals. */
export function addresses(slot: Slot): string[] {
  const groups = new Map<string, string[]>();
  for (const { operand } of slot.terminals) {
    const [, area, place] = /^(\w+) (.+)$/.exec(operand) ?? [];
    const there = groups.get(area ?? '') ?? [];
    if (area && place && there.at(-1) !== place) groups.set(area, [...there, place]);
  }
  if (groups.size === 0) return [range('PE', slot.inputs), range('PA', slot.outputs)].filter((text) => text !== '');
  return [...groups].map(([area, places]) =>
    places.length === 1 ? `${area} ${places[0]}` : `${area} ${places[0]}…${places[places.length - 1]}`,
  );
}

const range = (area: string, bytes?: Range | null) =>
  bytes?.bytes ? `${area} ${bytes.first}…${bytes.first + bytes.bytes - 1}` : '';
