// All texts of the project for a search, without copies of blocks of the CPU: what is typed counts, the other files are read once for each change of them.
import { connection } from '../connection';
import { workspace } from './workspace.svelte';

const AT_ONCE = 4;
/** No text, whatever its name says: machine code and pictures. */
const noText = /\.(mc7|svg|png|jpe?g|zip|state|rec|sqlite|wld|pdf)$/i;

export interface ProjectTexts {
  texts: Map<string, string>;
  /** Files that could not be read. */
  unread: string[];
}

class Texts {
  private stored = new Map<string, string>();
  private of = '';

  /** `revision`: another one, other files. Stops reading when it is no longer wanted. */
  async all(revision: string, wanted: () => boolean): Promise<ProjectTexts> {
    if (revision !== this.of) {
      this.of = revision;
      this.stored = new Map();
    }
    const texts = new Map<string, string>();
    const unread: string[] = [];
    const paths = workspace.files
      .map(({ path }) => path)
      .filter((path) => !noText.test(path) && !workspace.isCopy(path));
    const rest = [...paths];
    const read = async () => {
      for (let path = rest.shift(); path !== undefined && wanted(); path = rest.shift()) {
        const text = workspace.documents.get(path)?.text ?? this.stored.get(path) ?? (await this.fetch(path));
        if (text === undefined) unread.push(path);
        else texts.set(path, text);
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, read));
    return { texts: new Map(paths.flatMap((path) => (texts.has(path) ? [[path, texts.get(path)!]] : []))), unread };
  }

  private async fetch(path: string): Promise<string | undefined> {
    const answer = await connection.ask('files.read', { path }).catch(() => undefined);
    if (answer) this.stored.set(path, answer.text);
    return answer?.text;
  }
}

export const projectTexts = new Texts();
