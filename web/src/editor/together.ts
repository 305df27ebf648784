// Two panes that scroll sideways as one.

type Pane = Pick<HTMLElement, 'scrollLeft' | 'addEventListener' | 'removeEventListener'>;

/** The result parts them again. */
export function together(left: Pane, right: Pane): () => void {
  /** The one that has just been moved by the other: its event leads nowhere. */
  let moved: Pane | null = null;
  const follow = (one: Pane, other: Pane) => () => {
    if (moved === one) return void (moved = null);
    const before = other.scrollLeft;
    other.scrollLeft = one.scrollLeft;
    // The shorter text ends earlier; without a movement there is no event.
    if (other.scrollLeft !== before) moved = other;
  };
  const ways = [
    [left, follow(left, right)],
    [right, follow(right, left)],
  ] as const;
  for (const [pane, act] of ways) pane.addEventListener('scroll', act, { passive: true });
  return () => ways.forEach(([pane, act]) => pane.removeEventListener('scroll', act));
}
