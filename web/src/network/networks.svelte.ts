// The networks of the block at the cursor, as the server draws them. A network that did not change keeps its object, so
// that only what an edit has changed is drawn again.
import { connection, Refused, type FieldsOf } from '../connection';
import type { NetworkPicture } from '../connection/protocol';
import type { Mnemonics } from '../editor/mnemonics';
import { told } from '../i18n';
import { coalesced } from '../state/coalesced';

export type Wanted = FieldsOf<'networks.show'>;
export type View = NetworkPicture['view'];

/** What a network looks like, wherever it stands in the text. */
const looks = (one: NetworkPicture): string => JSON.stringify({ ...one, line: 0, end: 0, first: one.first && 1 });

/** Fresh pictures; what is the same as before is the object of before, or at least its shapes. */
export function merged(old: readonly NetworkPicture[], fresh: readonly NetworkPicture[]): NetworkPicture[] {
  const before = new Map(old.map((one) => [looks(one), one]));
  return fresh.map((one) => {
    const known = before.get(looks(one));
    if (!known) return one;
    if (known.line === one.line && known.end === one.end && known.first === one.first) return known;
    return { ...one, shapes: known.shapes, sentences: known.sentences };
  });
}

export class Networks {
  list = $state.raw<readonly NetworkPicture[]>([]);
  /** Of the text, and so of the names of elements. */
  mnemonics = $state<Mnemonics>('german');
  /** Lines of the block. */
  line = $state(0);
  end = $state(0);
  /** Why there is nothing to show. */
  refused = $state('');
  private wanted: Wanted | undefined;
  private waiting: (() => void)[] = [];
  private readonly look = coalesced(() => this.read());

  /** Done when a picture of this text, or of a later one, is there. */
  show(wanted: Wanted): Promise<void> {
    this.wanted = wanted;
    return new Promise((done) => {
      this.waiting.push(done);
      void this.look();
    });
  }

  at(line: number): NetworkPicture | undefined {
    return this.list.find((one) => one.line <= line && line <= one.end);
  }

  private async read(): Promise<void> {
    const { wanted } = this;
    const waiting = this.waiting.splice(0);
    if (!wanted) return;
    try {
      const answer = await connection.ask('networks.show', wanted);
      if (this.wanted?.file !== wanted.file) return;
      this.refused = '';
      this.mnemonics = answer.mnemonics;
      this.line = answer.line;
      this.end = answer.end;
      this.list = merged(this.list, answer.networks);
    } catch (error) {
      this.refused = error instanceof Refused ? told(error.problems[0]!) : String(error);
      this.list = [];
    } finally {
      for (const done of waiting) done();
    }
  }
}
