import { connection, type Events, type Kept, type Requests } from '../connection';
import { projectChange } from '../projects/change.svelte';
import { attempt } from '../state/messages.svelte';

export type Network = NonNullable<Requests['stations.list']['result']['network']>;
export type Now = Events['stations'];

const NS = 1e9;

/** The network as it is configured; several parts of the page show it. */
export class ConfiguredNetwork {
  network = $state.raw<Network | null>(null);

  /** The result ends it. */
  follow(): () => void {
    const kept = connection.keep('stations.list', {}, ({ network }) => (this.network = network));
    return () => kept.drop();
  }
}

/** The stations of the project while the page shows them. */
export class NetworkMonitor {
  network = $state.raw<Network | null>(null);
  now = $state.raw<Now | null>(null);
  /** Of each subnet, 0 to 1, in the last second of virtual time. */
  load = $state.raw<number[]>([]);
  known = $state(false);
  private before: Now | null = null;
  private kept: Kept[] = [];
  private end: (() => void) | null = null;

  follow(): void {
    this.end = connection.on('stations', (message) => this.receive(message));
    this.kept = [
      connection.keep('stations.list', {}, ({ network }) => {
        this.network = network;
        this.known = true;
      }) as Kept,
      connection.keep('stations.watch', { on: true }, undefined, 'stations.watch', { on: false }) as unknown as Kept,
    ];
  }

  leave(): void {
    for (const one of this.kept) one.drop();
    this.end?.();
  }

  receive(message: Now): void {
    this.now = message;
    const before = this.before;
    if (before === null || message.time < before.time || before.subnets.length !== message.subnets.length) {
      this.before = message;
      return;
    }
    if (message.time - before.time < NS) return;
    this.load = message.subnets.map(
      (one, index) => (one.busy - before.subnets[index]!.busy) / (message.time - before.time),
    );
    this.before = message;
  }

  show(station: string): Promise<unknown> {
    return projectChange.mine(() => connection.ask('stations.show', { station }));
  }

  command(station: string, command: Requests['stations.command']['fields']['command']): Promise<unknown> {
    return attempt(connection.ask('stations.command', { station, command }));
  }

  fault(fields: Requests['stations.fault']['fields']): Promise<unknown> {
    return attempt(connection.ask('stations.fault', fields));
  }
}

/** The bits of a GDS that somebody has to know of. */
export function meanings(word: number): ('lost' | 'otherLength' | 'restarted' | 'newData')[] {
  const bits = [
    [3, 'lost'],
    [6, 'otherLength'],
    [11, 'restarted'],
    [31, 'newData'],
  ] as const;
  return bits.filter(([bit]) => (word >>> bit) % 2 === 1).map(([, name]) => name);
}

export const hexadecimal = (word: number): string =>
  `DW#16#${(word >>> 0).toString(16).toUpperCase().padStart(8, '0')}`;
