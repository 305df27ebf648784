import { expect, test } from 'vitest';
import { compareBlocks, compareModules, compareSymbols, textsOf, type Look } from './compare';

const look = (some: Partial<Look>): Look => ({ name: '', blocks: [], symbols: [], racks: [], ...some });
const block = (id: string, code: string, source = '') => ({ id, code, checksum: '', source });

test('blocks differ by their code; another text of the same code is less', () => {
  const left = look({ blocks: [block('FC 10', 'A'), block('OB 1', 'U', '// old\nU'), block('FC 2', 'S', 'S \n')] });
  const right = look({
    blocks: [block('OB 1', 'U', '// new\nU'), block('FC 2', 'S', 'S'), block('FC 10', 'B'), block('DB 1', '0')],
  });
  expect(compareBlocks(left, right).map(({ id, state }) => `${id} ${state}`)).toEqual([
    'OB 1 text',
    'FC 2 same',
    'FC 10 different',
    'DB 1 onlyRight',
  ]);
  expect(compareBlocks(right, left).at(-1)!.state).toBe('onlyLeft');
  // The same instructions behind another interface.
  const declared = (checksum: string) => look({ blocks: [{ ...block('FB 1', 'U'), checksum }] });
  expect(compareBlocks(declared('0001'), declared('0002'))[0]!.state).toBe('different');
});

test('sources are shown where they tell the difference, else the code', () => {
  const pair = (left?: ReturnType<typeof block>, right?: ReturnType<typeof block>) =>
    compareBlocks(look({ blocks: left ? [left] : [] }), look({ blocks: right ? [right] : [] }))[0]!;
  expect(textsOf(pair(block('FC 1', 'a', 'A'), block('FC 1', 'b', 'B')), false)).toEqual({
    left: 'A',
    right: 'B',
    code: false,
  });
  expect(textsOf(pair(block('FC 1', 'a', 'A'), block('FC 1', 'b', 'B')), true)).toEqual({
    left: 'a',
    right: 'b',
    code: true,
  });
  // Nothing differs: the source can be read all the same.
  expect(textsOf(pair(block('FC 1', 'a', 'A'), block('FC 1', 'a', 'A')), false)).toMatchObject({
    left: 'A',
    code: false,
  });
  // The same text with another symbol table is other code.
  expect(textsOf(pair(block('FC 1', 'a', 'A'), block('FC 1', 'b', 'A')), false).code).toBe(true);
  expect(textsOf(pair(block('FC 1', 'a', 'A'), block('FC 1', 'b')), false).code).toBe(true);
  expect(textsOf(pair(block('FC 1', 'a', 'A')), false)).toEqual({ left: 'A', right: '', code: false });
});

test('without a source, statement stands beside statement: what is inserted moves no other', () => {
  const short = '0000: 52000000      U     E 0.0\n0004: 65000000      BE\n';
  const long = '0000: 52000000      U     E 0.0\n0004: 0000          NOP   0\n0006: 65000000      BE\n';
  const [pair] = compareBlocks(look({ blocks: [block('FC 1', short)] }), look({ blocks: [block('FC 1', long)] }));
  expect(textsOf(pair!, false)).toEqual({
    left: 'U     E 0.0\nBE\n',
    right: 'U     E 0.0\nNOP   0\nBE\n',
    code: true,
  });
  expect(textsOf(pair!, true).left).toBe(short);
  // STEP 5: words, and lines that have none.
  const listing = `0000: 2010             A    DB 16\n${' '.repeat(23)}NAME : X\n0001: 0000 1111 2222 3333  L    KH FACE\n`;
  const [step5] = compareBlocks(look({ blocks: [block('PB 1', listing)] }), look({ blocks: [] }));
  expect(textsOf({ ...step5!, left: block('PB 1', listing) }, false).left).toBe('A    DB 16\nNAME : X\nL    KH FACE\n');
});

test('symbols by name, modules by place', () => {
  const symbol = (name: string, operand: string, comment = '') => ({ symbol: name, operand, type: 'BOOL', comment });
  const rows = compareSymbols(
    look({ symbols: [symbol('Start', 'E 0.0'), symbol('Stop', 'E 0.1')] }),
    look({ symbols: [symbol('Stop', 'E 0.2'), symbol('Lamp', 'A 0.0')] }),
  );
  expect(rows.map(({ key, state }) => `${key} ${state}`)).toEqual([
    'Lamp onlyRight',
    'Start onlyLeft',
    'Stop different',
  ]);
  expect(rows[2]!.left).toEqual(['E 0.1', 'BOOL', '']);
  const slot = (at: string, name: string, first: number) =>
    ({
      slot: at,
      name,
      kind: 'digital',
      order: '',
      properties: [],
      inputs: { first, bytes: 2 },
      outputs: null,
    }) as never;
  const modules = compareModules(
    look({ racks: [{ rack: 0, slots: [slot('4', 'SM 321', 0), slot('10', 'SM 321', 4)] }] }),
    look({ racks: [{ rack: 0, slots: [slot('4', 'SM 321', 8), slot('10', 'SM 321', 4)] }] }),
  );
  expect(modules.map(({ key, state }) => `${key} ${state}`)).toEqual(['0/4 different', '0/10 same']);
  expect(modules[0]!.left).toEqual(['SM 321', 'E 0…1', '']);
  const both = {
    slot: '4',
    name: 'SM 323',
    kind: 'digital',
    order: '',
    properties: [],
    inputs: { first: 0, bytes: 1 },
  };
  const [mixed] = compareModules(
    look({ racks: [{ rack: 0, slots: [{ ...both, outputs: { first: 4, bytes: 1 } } as never] }] }),
    look({ racks: [{ rack: 0, slots: [{ ...both, outputs: { first: 5, bytes: 2 } } as never] }] }),
  );
  expect([mixed!.left[1], mixed!.right[1]]).toEqual(['E 0…0, A 4…4', 'E 0…0, A 5…6']);
});

test('the CPU is one row: its type, its order number, and what is set on it otherwise', () => {
  const cpu = (name: string, order: string, slot: string, ...properties: [string, string][]) =>
    look({
      racks: [
        { rack: 0, slots: [{ slot, name, kind: 'cpu', order, properties, inputs: null, outputs: null }] },
      ] as never,
    });
  const [row] = compareModules(
    cpu('CPU 313C', '6ES7 1', '2', ['timers', '256'], ['mpi_address', '2'], ['cycle_monitoring', '150ms']),
    cpu('CPU 313C', '6ES7 1', '2', ['timers', '256'], ['mpi_address', '5'], ['cycle_monitoring', '300ms']),
  );
  expect(row).toEqual({
    key: 'CPU',
    state: 'different',
    left: ['CPU 313C 6ES7 1', '', 'mpi_address: 2; cycle_monitoring: 150ms'],
    right: ['CPU 313C 6ES7 1', '', 'mpi_address: 5; cycle_monitoring: 300ms'],
  });
  const [other] = compareModules(cpu('SINUMERIK 810 GA3', '', ''), cpu('SINUMERIK 820 GA3', '', '2'));
  expect(other!.state).toBe('different');
  const [same] = compareModules(cpu('A', 'B', '2', ['timers', '256']), cpu('A', 'B', '2', ['timers', '256']), {
    module: (name) => `the ${name}`,
    property: ([name, value]) => `${value} ${name}`,
  });
  expect(same).toMatchObject({ state: 'same', left: ['the A B', '', '256 timers'] });
});
