// How this browser divides the room of the program view, in pixels; it outlives a reload.
import { kept } from '../state/kept.svelte';
import type { Panel } from './panels';

interface Range {
  least: number;
  most: number;
  otherwise: number;
}

export const ranges = {
  side: { least: 140, most: 480, otherwise: 232 },
  /** Where the list stands above the text. */
  sideHeight: { least: 120, most: 480, otherwise: 220 },
  declarations: { least: 64, most: 400, otherwise: 132 },
} satisfies Record<string, Range>;

/** Of what stands in the drawer below the text. A line of problems is enough: the text needs its room. */
export const drawerRanges: Record<Panel, Range> = {
  problems: { least: 26, most: 480, otherwise: 26 },
  watch: { least: 60, most: 560, otherwise: 180 },
  search: { least: 60, most: 560, otherwise: 240 },
  references: { least: 60, most: 560, otherwise: 240 },
  code: { least: 60, most: 480, otherwise: 260 },
  difference: { least: 60, most: 560, otherwise: 300 },
};

export const division = {
  side: kept('program.sideWidth', ranges.side.otherwise),
  sideHeight: kept('program.sideHeight', ranges.sideHeight.otherwise),
  sideShown: kept('program.side', true),
  declarations: kept('program.declarationsHeight', ranges.declarations.otherwise),
  drawer: kept<Partial<Record<Panel, number>>>('program.drawerHeights', {}),
  drawerShown: kept('program.drawer', true),
};
