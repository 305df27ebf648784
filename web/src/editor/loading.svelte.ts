// Loading from the program view: what the compiler refuses opens the list of problems.
import { translator } from '../i18n';
import { program } from '../i18n/texts/program';
import { messages } from '../state/messages.svelte';
import { workspace } from './workspace.svelte';

const MOST_ROWS = 4;
const t = translator(program);

/** Rows of the list that a load which failed wants to have in sight, until one succeeds. */
export const wanted = $state({ rows: 1 });

export async function load(blocks: string[] | undefined, showProblems: () => void): Promise<void> {
  const listed = () => {
    wanted.rows = Math.min(workspace.problems.length, MOST_ROWS);
    showProblems();
  };
  if (!(await workspace.load(blocks, listed))) return;
  wanted.rows = 1;
  messages.done(t('loaded'));
}
