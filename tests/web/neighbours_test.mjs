// The nearest of some rows is the first of them among all neighbours.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { nearest, nearestOf } from '../../web/browse/neighbours.js';

const count = 200,
  columns = [0, 1, 2];
// A sequence without a pattern, the same in every run.
const data = columns.map((k) => Float64Array.from({ length: count }, (_, row) => (row * (31 + 6 * k) + 7 * k) % 101));
const dataset = {
  count,
  isConstant: () => false,
  values: (column) => data[column],
  range: () => ({ least: 0, most: 100 }),
};

test('the nearest of some rows comes first among them', () => {
  const rows = Int32Array.from({ length: 20 }, (_, k) => 10 * k + 3);
  for (let row = 0; row < count; ++row) {
    const first = nearest(dataset, row, columns, count).find((other) => rows.includes(other.row));
    const found = nearestOf(dataset, row, columns, rows);
    assert.equal(found, first.row);
    assert.notEqual(found, row);
  }
});

test('of no rows, or of itself alone, none is nearest', () => {
  assert.equal(nearestOf(dataset, 4, columns, []), -1);
  assert.equal(nearestOf(dataset, 4, columns, [4]), -1);
});
