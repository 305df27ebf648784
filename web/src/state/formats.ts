/** The display formats with the narrowest and the widest operand they fit, in bits: the rows of src/tool/monitor/display_format.cpp. */
export const FORMATS: [name: string, shortest: number, widest: number][] = [
  ['AUTO', 1, 32],
  ['BOOL', 1, 1],
  ['BIN', 1, 32],
  ['HEX', 1, 32],
  ['DEC', 8, 32],
  ['UDEC', 1, 32],
  ['BCD', 8, 32],
  ['CHAR', 8, 32],
  ['REAL', 32, 32],
  ['S5TIME', 16, 16],
  ['TIME', 32, 32],
  ['DATE', 16, 16],
  ['TOD', 32, 32],
  ['COUNTER', 16, 16],
  ['POINTER', 32, 32],
  ['KG', 32, 32],
];

/** The formats that fit a width; all while the width is unknown (0). */
export function formatsOf(bits: number): string[] {
  return FORMATS.filter(([, shortest, widest]) => !bits || (bits >= shortest && bits <= widest)).map(([name]) => name);
}
