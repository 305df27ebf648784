const QUIET_MS = 300;

/** The action, when nobody has asked for it for a while, at the latest when the page goes: for what a key need not wait for. */
export function whenQuiet(action: () => void): { ask: () => void; cancel: () => void } {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const cancel = () => {
    if (timer === undefined) return;
    clearTimeout(timer);
    timer = undefined;
    globalThis.removeEventListener?.('pagehide', now);
  };
  const now = () => {
    cancel();
    action();
  };
  const ask = () => {
    if (timer === undefined) globalThis.addEventListener?.('pagehide', now);
    clearTimeout(timer);
    timer = setTimeout(now, QUIET_MS);
  };
  return { ask, cancel };
}
