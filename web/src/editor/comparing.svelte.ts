// What stands beside each other below the text: the chosen block in project and CPU, or our text and that of another browser.
import { untrack } from 'svelte';
import { plc } from '../state/plc.svelte';
import { compared, ofConflict, type Pair } from './compared';
import type { OpenDocument } from './document.svelte';
import { mnemonicsOf } from './mnemonics';

export class Comparing {
  /** The two texts of a conflict were asked for; while there is none, the block is shown. */
  conflict = $state(false);
  private pair = $state.raw<Pair | null>(null);
  private looks = 0;

  of(document: OpenDocument | null): Pair | null {
    return this.conflict && document?.conflict ? ofConflict(document.text, document.conflict.text) : this.pair;
  }

  /** As long as the calling component lives and while somebody looks: the block that is chosen, as project and CPU have it now. */
  follow(now: () => { looked: boolean; block: string; document: OpenDocument | null }): void {
    const wanted = $derived(now());
    const id = $derived(wanted.looked ? wanted.block : undefined);
    $effect(() => {
      void [plc.files, plc.program];
      if (id !== undefined) untrack(() => void this.look(id, wanted.document));
    });
  }

  private async look(id: string, document: OpenDocument | null): Promise<void> {
    const look = ++this.looks;
    const pair = id ? await compared(id, document ? mnemonicsOf(document.text) : 'german') : null;
    if (look === this.looks) this.pair = pair;
  }
}
