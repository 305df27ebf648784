// The file chooser of the page, for whoever has a button for it, and the way of files into an import.
import type { transfer } from '../i18n/texts/transfer';
import { messages } from '../state/messages.svelte';
import type { Dropped } from './dropped';
import { importer, MOST_BYTES } from './importer.svelte';

class Picker {
  private show: () => void = () => {};

  /** Whose chooser it is; the result ends that. */
  use(show: () => void): () => void {
    this.show = show;
    return () => (this.show = () => {});
  }
  open(): void {
    this.show();
  }
}
export const picker = new Picker();

type Say = (key: keyof typeof transfer & string, values?: Record<string, string | number>) => string;

export function takeFiles(files: readonly Dropped[], say: Say): void {
  const mega = 1 << 20;
  const bytes = files.reduce((sum, { file }) => sum + file.size, 0);
  const names = [...new Set(files.map(({ path }) => path.split('/', 1)[0]!))].join(', ');
  if (files.length === 0) messages.problem({ text: say('nothing') });
  else if (bytes > MOST_BYTES)
    messages.problem({ text: say('tooLarge', { names, size: Math.ceil(bytes / mega), most: MOST_BYTES / mega }) });
  else void importer.take(files);
}
