// What the panel of the NC shows: data by name, as docs/formats/nc.md lists them.

export interface Column {
  /** The datum of a row: "tool 5.2" in the second row of the fifth tool. */
  datum: (row: number) => string;
  title: (typeof titles)[number];
  /** Sums and positions of the workpiece are only read. */
  fixed?: true;
}

/** A table: one row for each number from `first` on. */
export interface Sheet {
  first: number;
  rows: number;
  columns: Column[];
}

export const titles = [
  'position', 'workpiece', 'feed', 'following', 'offsetSum', 'speed', 'pathFeed', 'programKind', 'programNumber',
  'blockNumber', 'group', 'value', 'coarse', 'fine', 'preset', 'external', 'g58', 'g59',
] as const; // prettier-ignore

export const AXES = 5;
export const PAGE = 20;

export const axes: Sheet = {
  first: 1,
  rows: AXES,
  columns: [
    { title: 'position', datum: (axis) => `position ${axis}` },
    { title: 'workpiece', datum: (axis) => `workpiece_position ${axis}`, fixed: true },
    { title: 'feed', datum: (axis) => `feed ${axis}` },
    { title: 'following', datum: (axis) => `following_error ${axis}` },
  ],
};

export const channels: Sheet = {
  first: 1,
  rows: 2,
  columns: [
    { title: 'pathFeed', datum: (channel) => `path_feed ${channel}` },
    { title: 'programKind', datum: (channel) => `program_pointer ${channel}.0.1` },
    { title: 'programNumber', datum: (channel) => `program_pointer ${channel}.0.2` },
    { title: 'blockNumber', datum: (channel) => `program_pointer ${channel}.0.3` },
    { title: 'group', datum: (channel) => `settable_group ${channel}` },
  ],
};

export const spindles: Sheet = {
  first: 1,
  rows: 2,
  columns: [{ title: 'speed', datum: (spindle) => `spindle_speed ${spindle}` }],
};

/** G54 is group 1. */
export const offsets = (group: number): Sheet => ({
  first: 1,
  rows: AXES,
  columns: [
    { title: 'coarse', datum: (axis) => `settable_offset ${group}.${axis}` },
    { title: 'fine', datum: (axis) => `settable_offset ${group}.${axis}.1` },
    { title: 'g58', datum: (axis) => `programmable_offset 1.${axis}` },
    { title: 'g59', datum: (axis) => `programmable_offset 2.${axis}` },
    { title: 'external', datum: (axis) => `external_offset ${axis}` },
    { title: 'preset', datum: (axis) => `preset ${axis}` },
    { title: 'offsetSum', datum: (axis) => `sum_offset ${axis}`, fixed: true },
  ],
});

const valuesOf = (datum: (row: number) => string, first: number, last: number): Sheet => ({
  first,
  rows: Math.max(0, Math.min(PAGE, last - first + 1)),
  columns: [{ title: 'value', datum }],
});

export interface Range {
  id: 'channel1' | 'channel2' | 'central' | 'machine' | 'machineBits' | 'setting' | 'settingBits';
  lowest: number;
  highest: number;
  datum: (row: number) => string;
}

/** What has so many numbers that a page of it is shown. */
export const ranges: { R: Range[]; data: Range[] } = {
  R: [
    { id: 'channel1', lowest: 0, highest: 499, datum: (row) => `R 1.${row}` },
    { id: 'channel2', lowest: 0, highest: 499, datum: (row) => `R 2.${row}` },
    { id: 'central', lowest: 900, highest: 999, datum: (row) => `R ${row}` },
  ],
  data: [
    { id: 'machine', lowest: 0, highest: 4999, datum: (row) => `MD ${row}` },
    { id: 'machineBits', lowest: 5000, highest: 9999, datum: (row) => `MD ${row}` },
    { id: 'setting', lowest: 0, highest: 4999, datum: (row) => `SD ${row}` },
    { id: 'settingBits', lowest: 5000, highest: 9999, datum: (row) => `SD ${row}` },
  ],
};

/** The page of a range that a number stands at the beginning of. */
export function page(range: Range, from: number): Sheet {
  const first = Math.min(Math.max(Math.trunc(from) || 0, range.lowest), range.highest);
  return valuesOf(range.datum, first, range.highest);
}

/** The tool D has P 0 to P 15. */
export const tool = (number: number): Sheet => ({
  first: 0,
  rows: 16,
  columns: [{ title: 'value', datum: (row) => `tool ${number}.${row}` }],
});

export const dataOf = (sheet: Sheet): string[] =>
  Array.from({ length: sheet.rows }, (_, row) =>
    sheet.columns.map(({ datum }) => `nc.${datum(sheet.first + row)}`),
  ).flat();

/** Signals of the NC to MB 17 to MB 24: on or off. */
export const signals = [
  { datum: 'machining_stop', id: 'machiningStop' },
  { datum: 'probe 1', id: 'probe1' },
  { datum: 'probe 2', id: 'probe2' },
  { datum: 'ring_full', id: 'ringFull' },
  { datum: 'ring_empty', id: 'ringEmpty' },
  { datum: 'serial', id: 'v24' },
  { datum: 'input_system', id: 'inch' },
] as const;

/** Places of the list of alarms that are shown. */
export const ALARMS = 12;
export const alarmPlaces = Array.from({ length: ALARMS }, (_, at) => `nc.alarm_list ${at + 1}`);
