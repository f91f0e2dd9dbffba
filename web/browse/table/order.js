// The order of the rows of a table.

/**
 * All rows by a column; rows without a number come last.
 * @param {Float64Array} values
 * @param {boolean} falling
 */
export function orderBy(values, falling) {
  const order = Int32Array.from(values.keys());
  const sign = falling ? -1 : 1;
  const last = (value) => (Number.isNaN(value) ? Infinity : sign * value);
  return order.sort((a, b) => {
    const x = last(values[a]),
      y = last(values[b]);
    return x < y ? -1 : x > y ? 1 : a - b;
  });
}

/** The rows of a mask, in an order. */
export function selectedInOrder(order, mask, count) {
  const rows = new Int32Array(count);
  let at = 0;
  for (const row of order) {
    if (mask[row]) rows[at++] = row;
  }
  return rows;
}
