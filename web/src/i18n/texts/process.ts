import type { Texts } from '..';

export const process = {
  title: ['Anlage', 'Process'],
} satisfies Texts;
