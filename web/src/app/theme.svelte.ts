import { among } from '../state/alike';
import { kept } from '../state/kept.svelte';

export type Theme = 'auto' | 'light' | 'dark';
const order: Theme[] = ['auto', 'light', 'dark'];

export const theme = kept<Theme>('theme', 'auto', among(...order));

export function nextTheme(): void {
  theme.value = order[(order.indexOf(theme.value) + 1) % order.length]!;
}
