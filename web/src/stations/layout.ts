// Where stations and the lines of their subnets lie in the picture: rows of cards, below each row the lines.

const WIDTH = 206;
const GAP = 18;
/** The height of a card, and from one line to the next: what is pressed there needs it. */
const SIZES = { dense: { card: 148, line: 36 }, finger: { card: 172, line: 44 } };
const LABELS = 118;
const ROW_GAP = 22;

export interface Planned {
  stations: { name: string }[];
  subnets: { name: string; kind: string; nodes: { station: string; address: number }[] }[];
}

export interface Stub {
  subnet: number;
  address: number;
  x: number;
  top: number;
  bottom: number;
}

export interface Place {
  x: number;
  y: number;
  stubs: Stub[];
}

export interface Line {
  subnet: number;
  x1: number;
  x2: number;
  y: number;
}

export interface Layout {
  card: { width: number; height: number };
  width: number;
  height: number;
  places: Place[];
  lines: Line[];
  /** From the first to the last row of a subnet. */
  trunks: { subnet: number; x: number; top: number; bottom: number }[];
}

export function layOut(network: Planned, width: number, finger = false): Layout {
  const { card, line } = SIZES[finger ? 'finger' : 'dense'];
  const columns = Math.max(1, Math.floor((width - LABELS) / (WIDTH + GAP)));
  const rowHeight = card + line * network.subnets.length + ROW_GAP;
  const rows = Math.ceil(network.stations.length / columns);
  const lineY = (row: number, subnet: number) => row * rowHeight + card + line * (subnet + 1);
  const nodes = network.subnets.map((subnet) => new Map(subnet.nodes.map((node) => [node.station, node.address])));
  const places = network.stations.map(({ name }, index): Place => {
    const row = Math.floor(index / columns);
    const x = LABELS + (index % columns) * (WIDTH + GAP);
    const y = row * rowHeight;
    const mine = network.subnets.map((_, subnet) => subnet).filter((subnet) => nodes[subnet]!.has(name));
    const stubs = mine.map((subnet, order) => ({
      subnet,
      address: nodes[subnet]!.get(name)!,
      x: x + 28 + order * 44,
      top: y + card,
      bottom: lineY(row, subnet),
    }));
    return { x, y, stubs };
  });
  const trunkX = (subnet: number) => LABELS - 10 - 6 * (subnet % 3);
  const lines = network.subnets.flatMap((_, subnet) =>
    Array.from({ length: Math.max(rows, 1) }, (_, row) => row)
      .map((row) => places.slice(row * columns, (row + 1) * columns))
      .map((some, row) => ({ some: some.filter((one) => one.stubs.some((stub) => stub.subnet === subnet)), row }))
      .filter(({ some, row }) => some.length > 0 || (row === 0 && nodes[subnet]!.size === 0))
      .map(({ some, row }) => ({
        subnet,
        x1: trunkX(subnet),
        x2: (some.at(-1)?.x ?? LABELS) + WIDTH,
        y: lineY(row, subnet),
      })),
  );
  const trunks = network.subnets
    .map((_, subnet) => ({ subnet, mine: lines.filter((one) => one.subnet === subnet) }))
    .filter(({ mine }) => mine.length > 1)
    .map(({ subnet, mine }) => ({ subnet, x: trunkX(subnet), top: mine[0]!.y, bottom: mine.at(-1)!.y }));
  return {
    card: { width: WIDTH, height: card },
    width: LABELS + Math.min(columns, Math.max(network.stations.length, 1)) * (WIDTH + GAP),
    height: Math.max(rows, 1) * rowHeight,
    places,
    lines,
    trunks,
  };
}
