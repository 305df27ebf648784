import { expect, test } from 'vitest';
import { unusedColumns, type StatusRow } from './status_columns';

const step5: StatusRow = [3, '1', '0', '0', '00000007', '00000000', '', '', '0003', '-', ''];
const step7: StatusRow = [3, '1', '0', '0', '00000007', '00000000', 'P#0.0', 'P#0.0', '0003', '-', '-'];

test('columns that a machine has no values for are not shown', () => {
  expect(unusedColumns([step5, step5])).toEqual(['ar1', 'ar2', 'di']);
  expect(unusedColumns([step7])).toEqual([]);
  expect(unusedColumns([step5, step7])).toEqual([]);
});
