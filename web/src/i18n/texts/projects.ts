import type { Texts } from '..';

export const projects = {
  title: ['Projekt', 'Project'],
} satisfies Texts;
