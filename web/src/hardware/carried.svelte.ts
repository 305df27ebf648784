// What is on its way to a slot: a module of the catalogue, or one that stands somewhere already.
import { plan, type ModuleType, type Place } from './plan.svelte';

export type Load = { type: ModuleType } | { from: Place; title: string; slots: [number, number] };

class Carried {
  load = $state.raw<Load | null>(null);

  get title(): string {
    if (!this.load) return '';
    return 'type' in this.load ? `${this.load.type.name} ${this.load.type.text}` : this.load.title;
  }

  /** Whether the kind of module belongs there; the server checks all the rest. */
  fits(slot: number): boolean {
    if (!this.load) return false;
    const [first, last] = 'type' in this.load ? this.load.type.slots : this.load.slots;
    return slot >= first && slot <= last;
  }

  /** True if it stands there now. */
  async drop(to: Place): Promise<boolean> {
    const load = this.load;
    this.load = null;
    if (!load) return false;
    return 'type' in load
      ? plan.change({ change: 'place', ...to, type: load.type.order })
      : plan.change({ change: 'move', ...load.from, toRack: to.rack, toSlot: to.slot });
  }
}

export const carried = new Carried();
