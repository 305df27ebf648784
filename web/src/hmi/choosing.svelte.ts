// How symbols of a picture are chosen, moved and copied, with the pointer and with the keyboard.
import { GRID, WIDTH, type Item } from './picture';
import { chosenOf, enclosed, moved, resized, toggled, type Chosen, type Point } from './several';

export interface Edited {
  readonly items: Item[];
  readonly chosen: Chosen;
  onchoose: (chosen: number[]) => void;
  /** `done`: the last one of a movement. */
  onmove: (items: Item[], done: boolean) => void;
  onremove: () => void;
  /** Copies, of those that are chosen or of those that were copied before. */
  oncopy: (items: Item[]) => void;
}

const steps: Record<string, Point> = {
  ArrowLeft: { x: -GRID, y: 0 },
  ArrowRight: { x: GRID, y: 0 },
  ArrowUp: { x: 0, y: -GRID },
  ArrowDown: { x: 0, y: GRID },
};
const adds = (event: MouseEvent | KeyboardEvent): boolean => event.ctrlKey || event.metaKey || event.shiftKey;
const capture = (event: PointerEvent) => (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);

export class Choosing {
  /** The corners of the frame that is being drawn. */
  frame = $state.raw<readonly [Point, Point] | null>(null);
  /** Of Ctrl C. */
  private taken: Item[] = [];
  private from: { at: Point; items: Item[]; only: number } | null = null;
  private pressed = false;
  /** The next symbol that gets the focus is not chosen instead of the others. */
  private several = false;

  constructor(
    private readonly edited: Edited,
    private readonly stage: () => HTMLElement,
  ) {}

  /** In the measures of the picture. */
  private place({ clientX, clientY }: MouseEvent): Point {
    const { left, top, width } = this.stage().getBoundingClientRect();
    return { x: ((clientX - left) * WIDTH) / width, y: ((clientY - top) * WIDTH) / width };
  }

  private choose(chosen: number[], several = chosen.length > 1): void {
    this.several = several;
    this.edited.onchoose(chosen);
  }

  down(event: PointerEvent, index: number): void {
    capture(event);
    this.pressed = true;
    const { chosen, items } = this.edited;
    if (adds(event)) return this.choose(toggled(chosen, index), true);
    // One of several that are chosen moves all of them; only a click chooses it alone.
    if (!chosen.includes(index)) this.choose([index]);
    this.from = { at: this.place(event), items, only: index };
  }

  private dragged(event: PointerEvent): Item[] {
    const { at, items } = this.from!;
    const { x, y } = this.place(event);
    return moved(items, this.edited.chosen, { x: x - at.x, y: y - at.y });
  }

  move(event: PointerEvent): void {
    if (this.from) this.edited.onmove(this.dragged(event), false);
  }

  up(event: PointerEvent): void {
    this.pressed = false;
    if (!this.from) return;
    const { items: before, only } = this.from;
    const after = this.dragged(event);
    this.from = null;
    this.edited.onmove(before, false);
    if (JSON.stringify(after) === JSON.stringify(before)) this.choose([only]);
    else this.edited.onmove(after, true);
  }

  focused(index: number): void {
    const { chosen } = this.edited;
    const kept = this.several && chosen.length > 0;
    if (!this.pressed && !kept && !chosen.includes(index)) this.choose([index]);
  }

  /** Beside the symbols: a frame round those that are meant. */
  frameDown(event: PointerEvent): void {
    if (event.target !== this.stage()) return;
    capture(event);
    const at = this.place(event);
    this.frame = [at, at];
  }

  frameMove(event: PointerEvent): void {
    if (this.frame) this.frame = [this.frame[0], this.place(event)];
  }

  frameUp(event: PointerEvent): void {
    if (!this.frame) return;
    const { items, chosen } = this.edited;
    const found = enclosed(items, ...this.frame);
    this.frame = null;
    this.choose(adds(event) ? [...new Set([...chosen, ...found])] : found);
  }

  all(): void {
    this.choose(this.edited.items.map((_, at) => at));
  }

  private remove(some: Chosen): void {
    this.choose([...some]);
    this.edited.onremove();
  }

  /** True if the key was for the symbols; it is about those that are chosen. */
  key(event: KeyboardEvent, index: number): boolean {
    const { items, chosen } = this.edited;
    const some = chosen.length > 0 ? chosen : [index];
    const step = steps[event.key];
    const control = event.ctrlKey || event.metaKey;
    if (control && event.key === 'c') this.taken = chosenOf(items, some);
    else if (control && event.key === 'v') this.edited.oncopy(this.taken.length ? this.taken : chosenOf(items, some));
    else if (control && event.key === 'd') this.edited.oncopy(chosenOf(items, some));
    else if (step && !control && !event.altKey)
      this.edited.onmove((event.shiftKey ? resized : moved)(items, some, step), true);
    else if (event.key === 'Delete') this.remove(some);
    // The first one stays chosen while the keyboard goes on to the next ones.
    else if (event.key === ' ') this.choose(this.several ? toggled(chosen, index) : [index], true);
    else if (event.key === 'Escape' && this.several) this.choose([index]);
    else return false;
    return true;
  }
}
