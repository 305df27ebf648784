// How high the rows of tables and lists are: dense as in STEP 7, or as a finger needs them.
import { kept } from '../state/kept.svelte';

const byFinger = window.matchMedia('(pointer: coarse)').matches;

export const comfortable = kept('comfortable', byFinger);
