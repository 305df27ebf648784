/** Where a text is gone to, beside its line. */
export interface Place {
  column?: number;
  /** By itself, so that it takes the keyboard from nobody. */
  unasked?: boolean;
  /** Of a block, which is read from there on. */
  head?: boolean;
}
