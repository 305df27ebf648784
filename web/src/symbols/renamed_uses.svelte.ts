// After the symbol table was saved: the texts that still have the old name of a symbol, until somebody has answered for them.
import { projectTexts } from '../editor/project_texts';
import type { Change } from '../editor/replaced';
import { isProse } from '../editor/search';
import { searching } from '../editor/searching.svelte';
import { workspace } from '../editor/workspace.svelte';
import { plc } from '../state/plc.svelte';
import { renamed, withNewNames, type Renaming } from './renamed';
import type { SymbolRow } from './rows';

class RenamedUses {
  renamings = $state.raw<Renaming[]>([]);
  count = $state(0);
  files = $state.raw<string[]>([]);
  /** The table that the texts were written for; null: nothing is open. */
  private before: readonly SymbolRow[] | null = null;
  private folder = '';

  get open(): boolean {
    return this.count > 0 && this.folder === plc.project?.folder;
  }

  /** `table`: the file of the symbols themselves. */
  async look(before: readonly SymbolRow[], after: readonly SymbolRow[], table: string): Promise<void> {
    const folder = plc.project?.folder ?? '';
    if (folder !== this.folder) this.leave();
    this.folder = folder;
    this.before ??= before;
    const renamings = renamed(this.before, after);
    const found = renamings.length > 0 ? await this.uses(renamings, table) : new Map<string, number>();
    if (found.size === 0) return this.leave();
    this.renamings = renamings;
    this.files = [...found.keys()];
    this.count = [...found.values()].reduce((all, one) => all + one, 0);
  }

  leave(): void {
    this.before = null;
    this.renamings = [];
    this.files = [];
    this.count = 0;
  }

  /** The files that had no unsaved changes are saved; as any replacement it can be taken back. The files that are still unsaved. */
  async replace(): Promise<string[]> {
    const changes: Change[] = [];
    const unsaved: string[] = [];
    let count = 0;
    for (const file of this.files) {
      const document = await workspace.fetch(file);
      if (!document) continue;
      const wasDirty = document.dirty;
      const before = document.text;
      const { text: after, count: places } = withNewNames(before, this.renamings);
      workspace.edit(document, after);
      changes.push({ file, before, after });
      count += places;
      if (wasDirty || !(await workspace.save(document))) unsaved.push(file);
    }
    searching.replaced = { folder: this.folder, count, changes };
    this.leave();
    return unsaved;
  }

  private async uses(renamings: readonly Renaming[], table: string): Promise<Map<string, number>> {
    workspace.enter(this.folder);
    await workspace.refreshFiles();
    const { texts } = await projectTexts.all(`${this.folder} ${plc.files}`, () => true);
    const found = new Map<string, number>();
    for (const [file, text] of texts) {
      if (file === table || isProse(file)) continue;
      const { count } = withNewNames(text, renamings);
      if (count > 0) found.set(file, count);
    }
    return found;
  }
}

export const renamedUses = new RenamedUses();
