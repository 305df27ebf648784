// What can be opened: examples, templates, the workspace folder.
import { connection } from '../connection';
import { attempt } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';

export interface Example {
  id: string;
  title: string;
  description: string;
}

export interface Template {
  id: string;
  title: string;
}

interface Listed {
  examples: Example[];
  templates: Template[];
  models: string[];
  recent: string[];
  folder: string;
}

/** The words of a text in Markdown. */
export const plain = (text: string): string => text.replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/[`*]/g, '');

class ProjectList {
  examples = $state.raw<Example[]>([]);
  templates = $state.raw<Template[]>([]);
  models = $state.raw<string[]>([]);
  recent = $state.raw<string[]>([]);
  folder = $state('');

  async read(): Promise<void> {
    const answer = await attempt(connection.ask<Listed>('projects.list'));
    if (answer) Object.assign(this, answer);
  }
}

export const projectList = new ProjectList();

export function followProjects(): void {
  $effect(() => {
    void plc.project?.folder;
    if (plc.phase === 'open') void projectList.read();
  });
}
