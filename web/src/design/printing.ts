// While the page is printed: a print dialog begins with the event, an emulated page with the medium.
import { flushSync } from 'svelte';

/** Tells when printing begins and ends; what it sets is on the page before it goes to paper. To be returned from an effect. */
export function followPrinting(tell: (on: boolean) => void): () => void {
  const media = matchMedia('print');
  const follow = (on: boolean) => flushSync(() => tell(on));
  const changed = () => follow(media.matches);
  const begins = () => follow(true);
  const ends = () => follow(false);
  media.addEventListener('change', changed);
  window.addEventListener('beforeprint', begins);
  window.addEventListener('afterprint', ends);
  return () => {
    media.removeEventListener('change', changed);
    window.removeEventListener('beforeprint', begins);
    window.removeEventListener('afterprint', ends);
  };
}
