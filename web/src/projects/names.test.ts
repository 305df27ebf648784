import { expect, test } from 'vitest';
import { copyName, fileName, nameIn } from './names';

test('a copy is named after its folder, and not like another project', () => {
  expect(copyName('/srv/merker/press', 'Kopie', [])).toBe('press Kopie');
  expect(copyName('/srv/merker/press/', 'Kopie', ['press Kopie', 'press Kopie 2'])).toBe('press Kopie 3');
  expect(copyName('/tmp/first.awl', 'copy', [])).toBe('first copy');
  expect(copyName('/tmp/a+b', 'copy', [])).toBe('a_b copy');
  expect(copyName('', 'copy', [])).toBe('copy');
});

test('a file keeps its name', () => {
  expect(fileName('sub/main.awl')).toBe('main.awl');
  expect(fileName('CPU: OB 1')).toBe('OB 1.awl');
});

test('a folder of the workspace has one name, wherever it was opened from', () => {
  expect(nameIn('/srv/merker', '/srv/merker/plants/press')).toBe('plants/press');
  expect(nameIn('/srv/merker/', '/srv/merker/press')).toBe('press');
  expect(nameIn('/srv/merker', 'press')).toBe('press');
  expect(nameIn('/srv/merker', '/srv/merker2/press')).toBe('/srv/merker2/press');
  expect(nameIn('', '/press')).toBe('/press');
});
