import { describe, expect, it } from 'vitest';
import { addressOf, baudOf, freeAddress, freeName, rateOf, type Subnet } from './nodes';

const subnet = (kind: string, nodes: Subnet['nodes'], slaves: Subnet['slaves'] = []): Subnet => ({
  name: `${kind}(1)`,
  kind,
  rate: '',
  highest: 31,
  nodes,
  slaves,
});

describe('addresses', () => {
  const mpi = subnet('mpi', [
    { station: 'Press', address: 2 },
    { station: 'Belt', address: 4 },
  ]);
  const ethernet = subnet('ethernet', [{ station: 'Press', address: 1, ip: '10.0.0.1' }]);

  it('are those of the station', () => {
    expect(addressOf(mpi, 'Belt')).toBe('4');
    expect(addressOf(ethernet, 'Press')).toBe('10.0.0.1');
    expect(addressOf(mpi, 'Saw')).toBe('');
  });

  it('are free', () => {
    expect(freeAddress(mpi)).toBe('3');
    expect(freeAddress(ethernet)).toBe('10.0.0.2');
    expect(freeAddress(subnet('ethernet', []))).toBe('192.168.0.1');
    expect(freeAddress(subnet('profibus', [], [{ address: 2, name: '', model: '' }]))).toBe('3');
  });
});

it('names a new subnet', () => {
  expect(freeName([subnet('MPI', [])], 'mpi')).toBe('MPI(2)');
  expect(freeName([subnet('MPI', [])], 'ethernet')).toBe('Ethernet(1)');
});

it('writes a rate as merker.toml has it', () => {
  expect(['187.5 kbit/s', '1.5 Mbit/s', '100 Mbit/s'].map(baudOf)).toEqual(['187.5k', '1.5M', '100M']);
  expect(['187.5k', '12M'].map(rateOf)).toEqual(['187.5 kbit/s', '12 Mbit/s']);
});
