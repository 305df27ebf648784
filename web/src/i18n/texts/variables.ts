import type { Texts } from '..';

export const variables = {
  title: ['Variablentabelle', 'Variable table'],
} satisfies Texts;
