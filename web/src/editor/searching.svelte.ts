import { keep, keptReplaced, type Replaced } from './replaced';

/** What is being looked for; it outlives the view. */
class Searching {
  text = $state('');
  replacement = $state('');
  matchCase = $state(false);
  wholeWord = $state(false);
  preview = $state(false);
  /** Somebody asked for it: its field is to get the focus. */
  wanted = $state(false);
  private last = $state.raw<Replaced | null>(keptReplaced(sessionStorage));

  /** What was replaced last: one click takes all of it back, also after a reload. */
  get replaced(): Replaced | null {
    return this.last;
  }
  set replaced(replaced: Replaced | null) {
    this.last = replaced;
    keep(sessionStorage, replaced);
  }
}
export const searching = new Searching();
