// One edit at a time: what is asked for while one is on its way is done behind it, to what it makes.
import { isTyped, type Key } from './keys';

export class Turn {
  busy = false;
  /** A key was refused: the text typed behind it was meant for what it did not make. */
  deaf = false;
  private ahead: (() => void)[] = [];

  async take(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    try {
      await work();
    } finally {
      this.busy = false;
    }
    while (!this.busy && this.ahead.length > 0) this.ahead.shift()!();
  }

  wait(act: () => void): void {
    this.ahead.push(act);
  }

  whenFree(act: () => void): void {
    if (this.busy) this.wait(act);
    else act();
  }

  forget(): void {
    this.ahead = [];
  }

  /** The text behind a refused key, up to its Enter, is meant for nothing that is there. */
  unheard(key: Key): boolean {
    if (!this.deaf) return false;
    this.deaf = isTyped(key) || key.key === 'Backspace' || key.key === ' ';
    return this.deaf || key.key === 'Enter';
  }
}
