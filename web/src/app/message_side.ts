// Good news lies over the lower right of the page, or the lower left if it would hide what has just been used there.

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** `column`: where it is now, on either side of a page of this width. */
export function sideFor(used: Box, column: Box, width: number): 'left' | 'right' {
  const room = column.right - column.left;
  const hides = (left: number): boolean =>
    used.left < left + room && used.right > left && used.top < column.bottom && used.bottom > column.top;
  return hides(width - room) && !hides(0) ? 'left' : 'right';
}
