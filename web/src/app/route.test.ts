import { expect, test } from 'vitest';
import { parseRoute, printRoute } from './route.svelte';

test('a route survives the address line', () => {
  const route = { view: 'program', params: { file: 'folder/a & b.awl', line: '12' } };
  expect(parseRoute(printRoute(route))).toEqual(route);
});

test('an address without view or parameters is a route too', () => {
  expect(parseRoute('')).toEqual({ view: '', params: {} });
  expect(parseRoute('#/io')).toEqual({ view: 'io', params: {} });
});
