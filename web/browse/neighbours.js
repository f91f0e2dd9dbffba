// The variants most like a given one.

/**
 * Root mean square difference from a row over some columns, each over its range.
 * @param {import('./dataset.js').Dataset} dataset
 * @param {number[]} columns
 * @returns {Float64Array} one for each row; NaN where a column has no number
 */
function distances(dataset, row, columns) {
  const sums = new Float64Array(dataset.count);
  const moving = columns.filter(
    (column) => !dataset.isConstant(column) && Number.isFinite(dataset.values(column)[row]),
  );
  for (const column of moving) {
    const values = dataset.values(column),
      { least, most } = dataset.range(column);
    const here = values[row],
      factor = 1 / (most - least);
    for (let other = 0; other < sums.length; ++other) {
      const step = factor * (values[other] - here);
      sums[other] += step * step;
    }
  }
  return sums.map((sum) => Math.sqrt(sum / Math.max(1, moving.length)));
}

/**
 * The one of `rows` that is nearest to a row by some columns, or -1.
 * @param {Iterable<number>} rows
 */
export function nearestOf(dataset, row, columns, rows) {
  const all = distances(dataset, row, columns);
  let best = -1,
    least = Infinity;
  for (const other of rows) {
    if (other === row || !(all[other] < least)) continue;
    best = other;
    least = all[other];
  }
  return best;
}

/**
 * The nearest other rows, the nearest first.
 * @returns {{row: number, distance: number}[]}
 */
export function nearest(dataset, row, columns, count) {
  const all = distances(dataset, row, columns);
  const found = [];
  for (let other = 0; other < all.length; ++other) {
    const distance = all[other];
    if (other === row || !(distance < (found.length < count ? Infinity : found[count - 1].distance))) continue;
    let at = found.length;
    while (at > 0 && found[at - 1].distance > distance) --at;
    found.splice(at, 0, { row: other, distance });
    found.length = Math.min(found.length, count);
  }
  return found;
}
