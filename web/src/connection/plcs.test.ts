import { expect, test } from 'vitest';
import { Entrance, enterPlc, pageAt, plcOf } from './plcs';

const page = 'http://127.0.0.1:8080/?token=abc&plc=3#/io';

test('the address says at which PLC the page is', () => {
  expect(plcOf(page)).toBe(3);
  expect(plcOf('http://127.0.0.1:8080/')).toBe(1);
  for (const wrong of ['0', '-1', '1.5', 'x', '', '99999']) expect(plcOf(`http://127.0.0.1/?plc=${wrong}`)).toBeNull();
});

test('the address of another PLC keeps the token', () => {
  expect(pageAt(page, 2, 'projects')).toBe('http://127.0.0.1:8080/?token=abc&plc=2#/projects');
  expect(pageAt(page, 1, 'io')).toBe('http://127.0.0.1:8080/?token=abc#/io');
});

function entered(address: string) {
  const kept: unknown[][] = [];
  const unknown: unknown[] = [];
  const dropped: number[] = [];
  const keep = (...given: unknown[]) => (kept.push(given), { update() {}, drop: () => dropped.push(1) });
  const entrance = enterPlc({ keep } as never, address, (first) => unknown.push(first));
  return { kept, unknown, dropped, entrance };
}

test('only who is elsewhere has to enter', () => {
  expect(entered('http://127.0.0.1/').kept).toEqual([]);
  expect(entered(page).kept.map((one) => one.slice(0, 2))).toEqual([['plcs.enter', { plc: 3 }]]);
});

test('what the first PLC tells before is not shown', () => {
  const entrance = new Entrance(3);
  entrance.begin();
  expect(entrance.pass({ mode: 'RUN', plcs: { here: 1, count: 2 } })).toBeNull();
  expect(entrance.pass({ time: 5 })).toBeNull();
  const own = { mode: 'STOP', plcs: { here: 3, count: 2 } } as const;
  expect(entrance.pass(own)).toBe(own);
  expect(entrance.pass({ time: 6 })).toEqual({ time: 6 });
  entrance.begin();
  expect(entrance.pass({ time: 7 })).toBeNull();
});

test('without such a PLC the page is at the first one', () => {
  const { kept, unknown, dropped, entrance } = entered(page);
  entrance.begin();
  entrance.pass({ mode: 'RUN', plcs: { here: 1, count: 1 } });
  entrance.pass({ time: 5 });
  (kept[0]!.at(-1) as () => void)();
  expect(unknown).toEqual([{ mode: 'RUN', plcs: { here: 1, count: 1 }, time: 5 }]);
  expect(dropped).toEqual([1]);
  entrance.begin();
  expect(entrance.pass({ time: 6 })).toEqual({ time: 6 });
  expect(entered('http://127.0.0.1/?plc=x').unknown).toEqual([{}]);
});
