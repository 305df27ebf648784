import { connection, type Events, type Kept } from '../connection';
import type { Axis, PlantRow, PlantValue } from '../connection/protocol';
import { attempt } from '../state/messages.svelte';
import { between, type Frame, type Values } from './motion';

export type Signal = PlantValue;
export type Plant = PlantRow;

const reducedMotion = window.matchMedia('(prefers-reduced-motion: reduce)');
const CALM_MS = 500;

/** The plants of the station: what they are, and their values as they move. */
export class Plants {
  list = $state.raw<Plant[]>([]);
  /** The positioning axis of the CPU, and what it shows by name. */
  axis = $state.raw<Axis | null>(null);
  axisShown = $state.raw<Values>({});
  /** False until the server has told which there are. */
  known = $state(false);
  /** What is shown: between the last two frames of the server. */
  shown = $state.raw<Record<string, Values>>({});
  private before: Frame | null = null;
  private latest: Frame | null = null;
  private drawn = 0;
  private kept: Kept | null = null;
  private ends: (() => void)[] = [];

  follow(): void {
    this.ends.push(connection.on('process', (message) => this.receive(message)));
    this.kept = connection.keep('process.watch', { on: true }, undefined, 'process.watch', { on: false });
    let next = requestAnimationFrame(
      function draw(this: Plants) {
        this.draw(performance.now());
        next = requestAnimationFrame(draw.bind(this));
      }.bind(this),
    );
    this.ends.push(() => cancelAnimationFrame(next));
  }

  leave(): void {
    this.kept?.drop();
    for (const end of this.ends) end();
    this.ends = [];
  }

  async load(): Promise<void> {
    const answer = await connection.ask('process.list').catch(() => null);
    this.list = answer?.plants ?? [];
    this.axis = answer?.axis ?? null;
    this.known = answer !== null;
    const now: Record<string, Values> = {};
    for (const plant of this.list)
      now[plant.name] = Object.fromEntries(plant.values.map((one) => [one.name, one.value]));
    this.before = null;
    this.latest = { at: performance.now(), plants: now };
  }

  /** `held`: pressed as long as somebody holds it; the server lets go when this page is gone. */
  set(plant: string, value: string, to: number, held = false): Promise<unknown> {
    return attempt(connection.ask('process.set', { plant, value, to, held }));
  }

  /** Stuck at a value, at the one it has (`'here'`), or working again (null). */
  async stick(plant: Plant, signal: Signal, at: number | 'here' | null): Promise<void> {
    const to = typeof at === 'number' ? { to: at } : {};
    await attempt(connection.ask('process.fault', { plant: plant.name, fault: signal.name, on: at !== null, ...to }));
    await this.load();
  }

  async reset(plant: string): Promise<void> {
    await attempt(connection.ask('process.reset', { plant }));
    await this.load();
  }

  /** Only what changed comes; the rest stays. */
  private receive(message: Events['process']): void {
    const plants = { ...this.latest?.plants };
    for (const [name, values] of Object.entries(message.plants)) plants[name] = { ...plants[name], ...values };
    this.before = this.latest;
    this.latest = { at: performance.now(), plants };
    this.axisShown = message.axis ?? {};
    this.takeFaults(message.stuck);
  }

  private takeFaults(stuck: Record<string, Values>): void {
    this.list = this.list.map((plant) => ({
      ...plant,
      values: plant.values.map((one) => ({ ...one, stuck: stuck[plant.name]?.[one.name] ?? null })),
    }));
  }

  private draw(now: number): void {
    if (!this.latest) return;
    if (reducedMotion.matches) {
      if (now - this.drawn < CALM_MS) return;
      this.drawn = now;
      this.shown = this.latest.plants;
    } else {
      const next = between(this.before, this.latest, now);
      if (next !== this.shown) this.shown = next;
    }
  }
}
