// Which networks are in sight: only these are drawn, a block may have hundreds.
export class InSight {
  numbers = $state.raw<ReadonlySet<number>>(new Set());
  private observer: IntersectionObserver | undefined;

  /** For use: on the place of a network (`data-card`); `root` scrolls. */
  watch = (node: HTMLElement, root: () => HTMLElement) => {
    this.observer ??= new IntersectionObserver((entries) => this.change(entries), {
      root: root(),
      rootMargin: '600px',
    });
    const { observer } = this;
    observer.observe(node);
    return { destroy: () => observer.unobserve(node) };
  };

  private change(entries: IntersectionObserverEntry[]): void {
    const now = new Set(this.numbers);
    for (const { target, isIntersecting } of entries) {
      const number = Number((target as HTMLElement).dataset.card);
      if (isIntersecting) now.add(number);
      else now.delete(number);
    }
    this.numbers = now;
  }
}
