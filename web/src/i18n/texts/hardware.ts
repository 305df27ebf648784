import type { Texts } from '..';

export const hardware = {
  title: ['Hardware', 'Hardware'],
} satisfies Texts;
