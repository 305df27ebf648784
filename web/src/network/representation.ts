// How this browser shows programs: the text, ladder, function blocks.
import { kept } from '../state/kept.svelte';
import type { View } from './networks.svelte';

export const representation = kept<View>('program.view', 'awl');

/** Whether the declaration table is shown: it takes the room of the program. */
export const declarationsShown = {
  text: kept('program.declarations', false),
  drawing: kept('program.drawnDeclarations', false),
};

// STEP 7's keys. A browser that keeps Ctrl and a digit for its tabs leaves them with Shift.
const views: Record<string, View> = { Digit1: 'kop', Digit2: 'awl', Digit3: 'fup' };

export const viewOf = (event: KeyboardEvent): View | undefined =>
  event.ctrlKey && !event.altKey ? views[event.code] : undefined;

/** Whether the comments of networks are shown. */
export const comments = kept('program.comments', true);
