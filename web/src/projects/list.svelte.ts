// What can be opened: examples, templates, the workspace folder.
import { connection, type Requests } from '../connection';
import { attempt } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';
import { nameIn } from './names';

type Listed = Requests['projects.list']['result'];

/** The words of a text in Markdown. */
export const plain = (text: string): string => text.replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/[`*]/g, '');

class ProjectList {
  examples = $state.raw<Listed['examples']>([]);
  templates = $state.raw<Listed['templates']>([]);
  models = $state.raw<string[]>([]);
  sinumerik = $state.raw<string[]>([]);
  projects = $state.raw<string[]>([]);
  recent = $state.raw<string[]>([]);
  folder = $state('');

  async read(): Promise<void> {
    const answer = await attempt(connection.ask('projects.list'));
    if (!answer) return;
    const recent = answer.recent.map((folder) => nameIn(answer.folder, folder));
    Object.assign(this, { ...answer, recent });
  }
}

export const projectList = new ProjectList();

export function followProjects(): void {
  $effect(() => {
    void plc.project?.folder;
    if (plc.phase === 'open') void projectList.read();
  });
}
