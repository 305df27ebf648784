// Where a fault has stopped the CPU or a breakpoint halts it, and what its registers hold, for as long as it stands there.
import { untrack } from 'svelte';
import { connection } from '../connection';
import { plc } from '../state/plc.svelte';
import { failedOf, type Failed } from './failed';

class Standing {
  at = $state.raw<Failed | null>(null);
  private looks = 0;

  constructor(private readonly stands: () => boolean) {}

  /** As long as the calling component lives. */
  follow(): void {
    $effect(() => {
      const stands = plc.live && this.stands() && plc.can('stacks');
      void [plc.diagnostics, plc.program, plc.project?.folder];
      untrack(() => void this.look(stands));
    });
  }

  private async look(stands: boolean): Promise<void> {
    const look = ++this.looks;
    const stacks = stands ? await connection.ask('diagnosis.stacks').catch(() => null) : null;
    if (look === this.looks) this.at = stacks && failedOf(stacks.interrupts);
  }
}

export const stopped = new Standing(() => plc.mode === 'STOP' && plc.stopReason !== '');
/** At each place anew: the object of the breakpoint is another one after each step. */
export const halted = new Standing(() => plc.breakpoint !== null);
