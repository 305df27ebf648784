/** A text before and after a replacement. */
export interface Change {
  file: string;
  before: string;
  after: string;
}
export interface Replaced {
  folder: string;
  count: number;
  changes: Change[];
}

/** What is being looked for; it outlives the view. */
class Searching {
  text = $state('');
  replacement = $state('');
  matchCase = $state(false);
  wholeWord = $state(false);
  preview = $state(false);
  /** Somebody asked for it: its field is to get the focus. */
  wanted = $state(false);
  /** What was replaced last: one click takes all of it back. */
  replaced = $state.raw<Replaced | null>(null);
}
export const searching = new Searching();
