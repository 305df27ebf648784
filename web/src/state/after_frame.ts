/** When the next frame has been shown: for what nobody waits for. */
export function afterFrame(action: () => void): void {
  requestAnimationFrame(() => setTimeout(action));
}
