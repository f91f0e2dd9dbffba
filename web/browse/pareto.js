// The rows that no other is better than.

/**
 * As explore/pareto.hpp: rows with a number that is not finite are left out; of equal rows all stay.
 * @param {Float64Array[]} columns
 * @param {boolean[]} minimize of each column
 * @param {Int32Array | number[]} rows that take part
 * @returns {number[]} rising
 */
export function paretoSet(columns, minimize, rows) {
  const costs = columns.map((values, k) => (minimize[k] ? values : values.map((value) => -value)));
  const order = [...rows].filter((row) => costs.every((cost) => Number.isFinite(cost[row])));
  // In lexicographic order a row can only be dominated by one before it.
  order.sort((a, b) => {
    for (const cost of costs) {
      if (cost[a] !== cost[b]) return cost[a] - cost[b];
    }
    return a - b;
  });
  const dominates = (a, b) => {
    let better = false;
    for (const cost of costs) {
      if (cost[a] > cost[b]) return false;
      if (cost[a] < cost[b]) better = true;
    }
    return better;
  };
  const front = [];
  for (const row of order) {
    // With two objectives only the last of the front can dominate.
    const rivals = costs.length === 2 ? front.slice(-1) : front;
    if (!rivals.some((rival) => dominates(rival, row))) front.push(row);
  }
  return front.sort((a, b) => a - b);
}
