import type { Texts } from '..';

export const program = {
  title: ['Programm', 'Program'],
} satisfies Texts;
