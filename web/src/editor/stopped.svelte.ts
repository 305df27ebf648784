// Where a fault has stopped the CPU, for as long as it is in STOP.
import { untrack } from 'svelte';
import { connection } from '../connection';
import { plc } from '../state/plc.svelte';
import { failedOf, type Failed } from './failed';

class Stopped {
  at = $state.raw<Failed | null>(null);
  private looks = 0;

  /** As long as the calling component lives. */
  follow(): void {
    $effect(() => {
      const stopped = plc.live && plc.mode === 'STOP' && plc.stopReason !== '' && plc.can('stacks');
      void [plc.diagnostics, plc.program, plc.project?.folder];
      untrack(() => void this.look(stopped));
    });
  }

  private async look(stopped: boolean): Promise<void> {
    const look = ++this.looks;
    const stacks = stopped ? await connection.ask('diagnosis.stacks').catch(() => null) : null;
    if (look === this.looks) this.at = stacks && failedOf(stacks.interrupts);
  }
}

export const stopped = new Stopped();
