// Another project is another PLC for all pages: who takes a running one from others is asked first, and the others are told.
import { untrack } from 'svelte';
import { connection } from '../connection';
import { translator } from '../i18n';
import { projects } from '../i18n/texts/projects';
import { attempt, messages } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';

const t = translator(projects);
/** The state that follows an answer is not later than this. */
const FOLLOWS_MS = 3000;

class ProjectChange {
  /** What the user is asked, and who waits for the answer. */
  asking = $state.raw<{
    name: string;
    mode: string;
    others: number;
    /** A PLC without a project; 0: there is none, or it would not help. */
    free: number;
    closes: boolean;
    decide: (go: boolean) => void;
  } | null>(null);
  private own = 0;

  /** Undefined: it was refused, or the user thought better of it. `closes`: no other project comes. */
  async run<T>(request: () => Promise<T>, closes = false): Promise<T | undefined> {
    if (this.takesFromOthers() && !(await this.confirmed(closes))) return undefined;
    return this.mine(request);
  }

  /** What takes nothing from others: another station of the same network. Nobody is asked, and this page is not told of it. */
  async mine<T>(request: () => Promise<T>): Promise<T | undefined> {
    this.own++;
    try {
      return await attempt(request());
    } finally {
      setTimeout(() => this.own--, FOLLOWS_MS);
    }
  }

  decide(go: boolean): void {
    this.asking?.decide(go);
    this.asking = null;
  }

  /** As long as the calling component lives: says when another page has changed the project. */
  follow(): void {
    let known: string | undefined;
    $effect(() => {
      if (!plc.live) return;
      const folder = plc.project?.folder ?? '';
      const name = plc.project?.name ?? '';
      if (known !== undefined && known !== folder && this.own === 0)
        untrack(() => messages.news(name ? t('changedByOther', { name }) : t('closedByOther')));
      known = folder;
    });
  }

  private takesFromOthers(): boolean {
    return plc.project !== null && plc.powered && plc.mode !== 'STOP' && plc.browsers > 1;
  }

  private async confirmed(closes: boolean): Promise<boolean> {
    this.decide(false);
    const free = closes ? 0 : await this.freePlc();
    return new Promise((decide) => {
      this.asking = { name: plc.project?.name ?? '', mode: plc.mode, others: plc.browsers - 1, free, closes, decide };
    });
  }

  private async freePlc(): Promise<number> {
    const { plcs } = await connection.ask('plcs.list').catch(() => ({ plcs: [] }));
    return plcs.find((one) => one.project === '' && one.browsers === 0)?.plc ?? 0;
  }
}

export const projectChange = new ProjectChange();
