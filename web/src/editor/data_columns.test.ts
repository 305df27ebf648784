import { describe, expect, it } from 'vitest';
import { columnWidths, cutTexts, type ColumnWidths, type Room } from './data_columns';

const row = {
  address: '0.0',
  section: '',
  name: 'Speed',
  type: 'REAL',
  initial: '1.500000e+000',
  actual: '2.500000e+000',
  comment: '',
  depth: 0,
};
const room: Room = { width: 900, digit: 8, smallDigit: 7, actual: 0, sections: false, begun: true };
const date = {
  ...row,
  type: 'DATE_AND_TIME',
  initial: 'DT#2024-02-29-12:30:45.123',
  actual: 'DT#2026-11-28-12:30:45.123',
};

const sum = ({ compact: _, digit: __, ...columns }: ColumnWidths) =>
  Object.values(columns).reduce((all, one) => all + one, 0);

describe('the columns of the data view', () => {
  it('are as wide as their texts where there is room; the comment takes the rest', () => {
    const widths = columnWidths([row, date], { ...room, width: 1000 });
    expect(widths.compact).toBe(false);
    expect(cutTexts(date, widths)).toEqual([]);
    expect(sum(widths)).toBe(1000);
    expect(widths.comment).toBeGreaterThan(104);
  });

  it('are smaller and closer where that shows all', () => {
    const widths = columnWidths([date], { ...room, width: 780 });
    expect(widths.compact).toBe(true);
    expect(cutTexts(date, widths)).toEqual([]);
  });

  it('give the actual value its width first, on a tablet too', () => {
    const told = { ...date, comment: 'of the last batch' };
    const widths = columnWidths([told], { ...room, width: 566 });
    expect(cutTexts(told, widths)).toEqual(['type', 'initial', 'comment']);
    expect(widths.initial).toBeGreaterThan(47);
    expect(sum(widths)).toBe(566);
  });

  it('have none for comments on a tablet where there are none', () => {
    const widths = columnWidths([row, date], { ...room, width: 566 });
    expect(widths.comment).toBe(0);
    expect(cutTexts(row, widths)).toEqual([]);
  });

  it('keep the width that an actual value once had', () => {
    expect(columnWidths([row], { ...room, actual: 30 }).actual).toBe(30 * 8 + 18);
  });

  it('let a long text take no more than is left', () => {
    const text = { ...row, type: 'STRING [254]', actual: 'x'.repeat(254) };
    const widths = columnWidths([text], room);
    expect(cutTexts(text, widths)).toEqual(['actual']);
    expect(sum(widths)).toBe(900);
  });

  it('leave out what the block does not have', () => {
    const widths = columnWidths([row], { ...room, begun: false });
    expect([widths.initial, widths.section]).toEqual([0, 0]);
  });
});
