// Which networks are in sight: only these are drawn, a block may have hundreds.
export class InSight {
  numbers = $state.raw<ReadonlySet<number>>(new Set());

  /** For use: on the place of a network; `root` scrolls. */
  watch = (node: HTMLElement, { number, root }: { number: number; root: () => HTMLElement }) => {
    const observer = new IntersectionObserver((entries) => this.change(number, entries.at(-1)!.isIntersecting), {
      root: root(),
      rootMargin: '600px',
    });
    observer.observe(node);
    return { destroy: () => observer.disconnect() };
  };

  private change(number: number, visible: boolean): void {
    const now = new Set(this.numbers);
    if (visible) now.add(number);
    else now.delete(number);
    this.numbers = now;
  }
}
