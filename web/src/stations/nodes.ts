// Addresses of stations on a subnet, as they are typed.
import type { Network } from './network.svelte';

export type Subnet = Network['subnets'][number];

export const KINDS = { mpi: 'MPI', ethernet: 'Ethernet', profibus: 'PROFIBUS' } as const;
export type SubnetKind = keyof typeof KINDS;

/** Of a new CPU (S7-NET-03); 0 is the programming device, 1 an operator panel. */
const FIRST_STATION = 2;
const FIRST_HOST = 1;
const USUAL_ETHERNET = '192.168.0.1';

/** Empty: it is not on the subnet. */
export function addressOf(subnet: Subnet, station: string): string {
  const node = subnet.nodes.find((one) => one.station === station);
  return node ? (node.ip ?? String(node.address)) : '';
}

export function freeAddress(subnet: Subnet): string {
  const used = new Set([...subnet.nodes, ...subnet.slaves].map((one) => one.address));
  const ethernet = subnet.kind === 'ethernet';
  let free = ethernet ? FIRST_HOST : FIRST_STATION;
  while (used.has(free)) free++;
  if (!ethernet) return String(free);
  return (subnet.nodes[0]?.ip ?? USUAL_ETHERNET).replace(/\d+$/, String(free));
}

/** "MPI(2)": the first name of this kind that no subnet has. */
export function freeName(subnets: Subnet[], kind: SubnetKind): string {
  const word = KINDS[kind];
  let number = 1;
  while (subnets.some((one) => one.name === `${word}(${number})`)) number++;
  return `${word}(${number})`;
}

/** "187.5 kbit/s" as merker.toml has it: "187.5k". */
export const baudOf = (rate: string): string => rate.replace(' kbit/s', 'k').replace(' Mbit/s', 'M');

export const rateOf = (baud: string): string => baud.replace('k', ' kbit/s').replace('M', ' Mbit/s');

/** S7-NET-25 */
export const BAUDS: Record<string, string[]> = {
  mpi: ['19.2k', '187.5k'],
  ethernet: ['10M', '100M'],
  profibus: ['9.6k', '19.2k', '45.45k', '93.75k', '187.5k', '500k', '1.5M', '3M', '6M', '12M'],
};

/** S7-NET-02 */
export const HIGHEST = [15, 31, 63, 126];
