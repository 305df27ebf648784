// Two texts beside each other.
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

/** Our text of the block and the one the CPU has, both printed by the same hand. */
export async function compared(id: string, mnemonics: Mnemonics): Promise<Pair> {
  const listing = async (of: Side) =>
    (await attempt(connection.ask('program.listing', { block: id, side: of, mnemonics })))?.text ?? '';
  return {
    block: id,
    left: { title: `${t('compareProject')}: ${id}`, text: await listing('offline') },
    right: { title: `${t('compareCpu')}: ${id}`, text: await listing('online') },
  };
}

/** Our text and that of another browser. */
export const ofConflict = (mine: string, theirs: string): Pair => ({
  left: { title: t('compareMine'), text: mine },
  right: { title: t('compareTheirs'), text: theirs },
});
