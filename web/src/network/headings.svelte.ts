// The open forms of titles, comments and labels: a text that is refused stays in its form.
import { SvelteMap } from 'svelte/reactivity';

/** The field in which one types; a new object takes the keyboard there again. */
export interface HeadingField {
  name: 'title' | 'label';
}

export class Headings {
  private readonly fields = new SvelteMap<number, HeadingField>();

  /** undefined: the form of this network is closed. */
  at(number: number): HeadingField | undefined {
    return this.fields.get(number);
  }
  show(number: number, name: HeadingField['name']): void {
    this.fields.set(number, { name });
  }
  toggle(number: number): void {
    if (!this.fields.delete(number)) this.show(number, 'title');
  }
  close(number: number): void {
    this.fields.delete(number);
  }
  clear(): void {
    this.fields.clear();
  }
}
