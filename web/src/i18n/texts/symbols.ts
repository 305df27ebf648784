import type { Texts } from '..';

export const symbols = {
  title: ['Symbole', 'Symbols'],
} satisfies Texts;
