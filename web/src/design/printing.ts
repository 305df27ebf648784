// While the page is printed: a print dialog begins with the event, an emulated page with the medium.
import { flushSync } from 'svelte';

/** Of the papers of a view the one that is printed; the browser's own command prints the one without a name. */
let wanted = '';

/** Opens the browser's dialog. */
export function print(paper: string): void {
  wanted = paper;
  window.print();
}

/** Tells when printing begins and ends; what it sets is on the page before it goes to paper. To be returned from an effect. */
export function followPrinting(tell: (on: boolean) => void, paper = ''): () => void {
  const media = matchMedia('print');
  const begins = () => flushSync(() => tell(wanted === paper));
  const ends = () => {
    flushSync(() => tell(false));
    wanted = '';
  };
  const changed = () => (media.matches ? begins() : ends());
  media.addEventListener('change', changed);
  window.addEventListener('beforeprint', begins);
  window.addEventListener('afterprint', ends);
  return () => {
    media.removeEventListener('change', changed);
    window.removeEventListener('beforeprint', begins);
    window.removeEventListener('afterprint', ends);
  };
}
