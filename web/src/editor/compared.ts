// Two texts beside each other.
import { compareBlocks, textsOf } from '../compare/compare';
import { connection } from '../connection';
import { translator } from '../i18n';
import { program } from '../i18n/texts/program';
import { attempt } from '../state/messages.svelte';
import type { Mnemonics } from './mnemonics';
import type { Side } from './workspace.svelte';

export interface Titled {
  title: string;
  text: string;
}
export interface Pair {
  left: Titled;
  right: Titled;
  /** Of project and CPU. */
  block?: string;
}
const t = translator(program);

/** The block of the project and that of the CPU: their sources, or their statements where one has no source. */
export async function compared(id: string, mnemonics: Mnemonics): Promise<Pair> {
  const look = (side: Side) => attempt(connection.ask('projects.look', { side, mnemonics }));
  const [offline, online] = [await look('offline'), await look('online')];
  const pair = offline && online && compareBlocks(offline, online).find((one) => one.id === id);
  const texts = pair ? textsOf(pair, false) : { left: '', right: '' };
  return {
    block: id,
    left: { title: `${t('compareProject')}: ${id}`, text: texts.left },
    right: { title: `${t('compareCpu')}: ${id}`, text: texts.right },
  };
}

/** Our text and that of another browser. */
export const ofConflict = (mine: string, theirs: string): Pair => ({
  left: { title: t('compareMine'), text: mine },
  right: { title: t('compareTheirs'), text: theirs },
});
