import { expect, test } from 'vitest';
import { together } from './together';

/** Scrolls as far as its text is long, and tells of a movement later, as a browser does. */
class Pane extends EventTarget {
  private at = 0;
  events = 0;
  constructor(private readonly most: number) {
    super();
  }
  get scrollLeft(): number {
    return this.at;
  }
  set scrollLeft(wanted: number) {
    const next = Math.max(0, Math.min(wanted, this.most));
    if (next !== this.at) this.events++;
    this.at = next;
  }
  tell(): void {
    for (; this.events > 0; this.events--) this.dispatchEvent(new Event('scroll'));
  }
}
const panes = (left: number, right: number) => {
  const both = [new Pane(left), new Pane(right)] as const;
  const part = together(both[0] as never, both[1] as never);
  const settle = () => both.forEach((one) => one.tell());
  const at = () => (settle(), settle(), both.map(({ scrollLeft }) => scrollLeft));
  return { left: both[0], right: both[1], part, at };
};

test('either pane takes the other one with it', () => {
  const { left, right, at } = panes(500, 500);
  right.scrollLeft = 120;
  expect(at()).toEqual([120, 120]);
  left.scrollLeft = 30;
  expect(at()).toEqual([30, 30]);
});

test('a shorter text stays at its end and does not pull the longer one back', () => {
  const { right, at } = panes(100, 500);
  right.scrollLeft = 300;
  expect(at()).toEqual([100, 300]);
  right.scrollLeft = 400;
  expect(at()).toEqual([100, 400]);
  right.scrollLeft = 40;
  expect(at()).toEqual([40, 40]);
});

test('parted they go their own ways', () => {
  const { left, part, at } = panes(500, 500);
  part();
  left.scrollLeft = 50;
  expect(at()).toEqual([50, 0]);
});
