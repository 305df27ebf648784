// How the curves look: colour and dash together tell them apart, colours follow the theme.
const DASHES = [[], [8, 4], [2, 3], [10, 3, 2, 3]];
const COLOURS = 6;

export const dashOf = (index: number) => DASHES[Math.floor(index / COLOURS) % DASHES.length]!;
export const tokenOf = (index: number) => `--curve-${(index % COLOURS) + 1}`;

/** A colour of the design as the canvas wants it. */
export function colour(token: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(token).trim();
}
