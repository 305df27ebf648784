// A placed element or a whole network is moved with the mouse: shapes of a drawing have no drag and drop of the browser.
import { isElement, move, type Dragged } from './clipboard';
import type { Editing } from './editing.svelte';
import { itemAt } from './items';

/** How far the mouse goes before it drags. */
const FAR = 6;

export class PointerDrag {
  active = $state(false);
  private from: { x: number; y: number; dragged: Dragged } | null = null;

  constructor(private readonly editing: Editing) {}

  begin(event: PointerEvent): void {
    const dragged = event.button === 0 && event.pointerType !== 'touch' ? this.at(event.target as Element) : null;
    const can = dragged && !this.editing.props.document.readonly && (!dragged.item || isElement(dragged.item));
    this.from = can ? { x: event.clientX, y: event.clientY, dragged } : null;
  }

  moved(event: PointerEvent): void {
    if (this.from && Math.hypot(event.clientX - this.from.x, event.clientY - this.from.y) > FAR) this.active = true;
  }

  /** Dropped: behind the element, or the network, that is there. */
  end(event: PointerEvent): void {
    const { from, active } = this;
    this.cancel();
    const to = from && active && this.at(document.elementFromPoint(event.clientX, event.clientY));
    if (!to || (to.number === from.dragged.number && to.item?.node === from.dragged.item?.node)) return;
    const { editing } = this;
    editing.turn.whenFree(() => {
      editing.chosen = to.number;
      editing.selected = to.item;
      move(editing, from.dragged, from.dragged.item ? to.item : null);
    });
  }

  cancel(): void {
    this.from = null;
    this.active = false;
  }

  private at(element: Element | null): Dragged | null {
    const number = Number(element?.closest<HTMLElement>('.networks [data-network]')?.dataset.network);
    const shapes = this.editing.networks.list.find((one) => one.number === number)?.shapes;
    if (!shapes) return null;
    if (element!.closest('[data-head]')) return { number, item: null };
    const place = element!.closest<SVGElement>('[data-node]')?.dataset;
    const item =
      place && itemAt(shapes, { node: Number(place.node), pin: Number(place.pin), first: Number(place.first) });
    return item ? { number, item } : null;
  }
}
