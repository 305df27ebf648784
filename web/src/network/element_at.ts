// The element of the page that shows a place of a network.
import type { Place } from './items';

/** null: the heading of the network. */
export function elementAt(host: Element, number: number, place: Place | null): HTMLElement | SVGElement | null {
  const card = host.querySelector(`[data-network="${number}"]`);
  const head = card?.querySelector<HTMLElement>('[data-head]') ?? null;
  if (!place) return head;
  const { node, pin, first } = place;
  return card?.querySelector<SVGElement>(`[data-node="${node}"][data-pin="${pin}"][data-first="${first}"]`) ?? head;
}

/** The network at whose heading this stands. */
export function headingOf(element: Element): number | undefined {
  const card = element.closest('header')?.closest<HTMLElement>('[data-card]');
  return card ? Number(card.dataset['card']) : undefined;
}
