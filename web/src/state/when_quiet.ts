const QUIET_MS = 300;

/** The action, when nobody has asked for it for a while, at the latest when the page goes: for what a key need not wait for. */
export function whenQuiet(action: () => void): { ask: () => void; cancel: () => void } {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const cancel = () => {
    clearTimeout(timer);
    globalThis.removeEventListener?.('pagehide', now);
  };
  const now = () => {
    cancel();
    action();
  };
  const ask = () => {
    cancel();
    timer = setTimeout(now, QUIET_MS);
    globalThis.addEventListener?.('pagehide', now);
  };
  return { ask, cancel };
}
