import { connection } from '../connection';

/** The files of the project that end like this, by their names without it. */
export class ProjectFiles {
  names = $state<string[]>([]);

  constructor(private readonly ending: string) {}

  async list(): Promise<void> {
    const answer = await connection.ask('files.list').catch(() => null);
    if (!answer) return;
    this.names = answer.files
      .map((file) => file.path)
      .filter((path) => path.toLowerCase().endsWith(this.ending))
      .map((path) => path.slice(0, -this.ending.length));
  }

  has = (name: string): boolean => this.names.includes(name.trim());
  path = (name: string): string => name.trim().replace(/[\\:*?"<>|]+/g, '-') + this.ending;
}
