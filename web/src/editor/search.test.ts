import { expect, test } from 'vitest';
import { around, find, isProse, replaceAt, replacedLine } from './search';

const source = '      U     "Slider small";\r\n// the sliders\n      =     #slider;\n';
const query = (text: string, matchCase = false, wholeWord = false) => ({ text, matchCase, wholeWord });
const places = (...args: Parameters<typeof query>) =>
  find('a.awl', source, query(...args)).map(({ line, from, to }) => `${line}:${from}-${to}`);

test('a part of a word is found, whatever its letters', () => {
  expect(places('slider')).toEqual(['1:13-19', '2:7-13', '3:13-19']);
  expect(places('Slider', true)).toEqual(['1:13-19']);
  expect(places('slider', false, true)).toEqual(['1:13-19', '3:13-19']);
  expect(places('')).toEqual([]);
});

test('letters that become longer in small move no place', () => {
  const [hit] = find('a', 'İİ Motor', query('motor'));
  expect([hit!.from, hit!.to]).toEqual([3, 8]);
});

test('what is found gives way, ends of lines stay', () => {
  const hits = find('a.awl', source, query('slider'));
  expect(replaceAt(source, hits, 'x')).toBe('      U     "x small";\r\n// the xs\n      =     #x;\n');
  expect(replaceAt(source, hits.slice(1, 2), '')).toContain('// the s\n');
  expect(replaceAt('aaaa', find('a', 'aaaa', query('aa')), 'aaa')).toBe('aaaaaa');
  expect(replacedLine(hits[2]!, 'Klein')).toBe('      =     #Klein;');
});

test('a row shows what stands around it', () => {
  expect(around(find('a', source, query('small'))[0]!)).toEqual(['U     "Slider ', 'small', '";']);
  expect(around({ file: '', line: 1, from: 100, to: 101, text: 'x'.repeat(300) }, 10)).toEqual([
    `…${'x'.repeat(10)}`,
    'x',
    'x'.repeat(20),
  ]);
});

test('what is written about the project is no source', () => {
  expect(['README.md', 'german.txt', 'notes/OLD.TXT'].every(isProse)).toBe(true);
  expect(['main.awl', 'main.sym', 'md.vat', 'txt'].some(isProse)).toBe(false);
});
