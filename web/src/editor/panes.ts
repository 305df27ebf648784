// F6 goes round the parts of the program view as round the panes of a window: list, bar, text, drawer, messages.

const PANES = [
  '.side:not([hidden])',
  '.work [role=toolbar]',
  '.work > .text:not([hidden])',
  '.work > .panel',
  '.messages',
];
/** What has the keyboard of a pane first: the chosen row or tab, else the first control. */
const FIRST = [
  '.cm-content',
  '[role=treeitem][tabindex="0"]',
  '[role=tab][tabindex="0"]',
  '[tabindex="0"]',
  'button:enabled, input:enabled, select:enabled',
];

const last = new WeakMap<Element, HTMLElement>();

/** The focus inside of shadow roots. */
function focused(): Element | null {
  let element = document.activeElement;
  while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
  return element;
}

const canTake = (element: HTMLElement): boolean => element.isConnected && element.getClientRects().length > 0;

function firstOf(pane: Element): HTMLElement | undefined {
  const roots = [pane, ...[...pane.querySelectorAll('*')].flatMap((one) => one.shadowRoot ?? [])];
  for (const wanted of FIRST)
    for (const root of roots)
      for (const found of root.querySelectorAll<HTMLElement>(wanted)) if (canTake(found)) return found;
  return undefined;
}

/** True if the key was this one. */
export function paneKey(event: KeyboardEvent): boolean {
  if (event.key !== 'F6' || event.ctrlKey || event.altKey || event.metaKey) return false;
  const panes = PANES.flatMap((one) => document.querySelector(one) ?? []).filter(firstOf);
  const here = panes.findIndex((one) => one.contains(document.activeElement));
  const now = focused();
  if (here >= 0 && now instanceof HTMLElement) last.set(panes[here]!, now);
  const step = event.shiftKey ? -1 : 1;
  const next = panes[here < 0 ? (step > 0 ? 0 : panes.length - 1) : (here + step + panes.length) % panes.length];
  if (!next) return true;
  const before = last.get(next);
  (before && canTake(before) ? before : firstOf(next)!).focus();
  return true;
}
