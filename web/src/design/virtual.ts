// Which rows of a long table are in the document: those in sight and some around them.

export interface Span {
  first: number;
  /** Behind the last one. */
  end: number;
}

/** Rows above and below those in sight, and the step in which the span moves: scrolling by a row changes nothing. */
const SPARE = 8;
const STEP = 8;

/** `hidden`: how much of the rows lies above the edge of what is seen, in pixels; `height`: how much is seen. */
export function rowsInSight(hidden: number, height: number, rowHeight: number, count: number): Span {
  const top = Math.floor(Math.max(hidden, 0) / rowHeight / STEP) * STEP;
  const bottom = Math.ceil((Math.max(hidden, 0) + height) / rowHeight / STEP) * STEP;
  const end = Math.max(0, Math.min(count, bottom + SPARE));
  return { first: Math.max(0, Math.min(top - SPARE, end)), end };
}

/** What may scroll the element, the nearest first. */
export function scrollersOf(element: Element): Element[] {
  const found: Element[] = [];
  for (let up = element.parentElement; up; up = up.parentElement)
    if (/auto|scroll/.test(getComputedStyle(up).overflowY)) found.push(up);
  return [...found, document.documentElement];
}

/** The part of the window in which the element can be seen: a frame that is as high as its content hides nothing. */
export function windowOf(scrollers: readonly Element[]): { top: number; bottom: number } {
  const rects = scrollers.slice(0, -1).map((one) => one.getBoundingClientRect());
  return {
    top: Math.max(0, ...rects.map(({ top }) => top)),
    bottom: Math.min(innerHeight, ...rects.map(({ bottom }) => bottom)),
  };
}
