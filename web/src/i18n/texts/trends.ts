import type { Texts } from '..';

export const trends = {
  title: ['Kurven', 'Trends'],
} satisfies Texts;
