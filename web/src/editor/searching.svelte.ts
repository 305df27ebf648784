/** What is being looked for; it outlives the view. */
class Searching {
  text = $state('');
  replacement = $state('');
  matchCase = $state(false);
  wholeWord = $state(false);
  preview = $state(false);
  /** Somebody asked for it: its field is to get the focus. */
  wanted = $state(false);
}
export const searching = new Searching();
