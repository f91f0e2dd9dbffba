// How much a variable has to do with the metrics.

const most = 4000; // rows looked at

// Correlation of two columns over some rows.
function correlation(a, b, rows) {
  let n = 0,
    sa = 0,
    sb = 0,
    saa = 0,
    sbb = 0,
    sab = 0;
  for (const row of rows) {
    const x = a[row],
      y = b[row];
    if (!Number.isFinite(x) || !Number.isFinite(y)) continue;
    n += 1;
    sa += x;
    sb += y;
    saa += x * x;
    sbb += y * y;
    sab += x * y;
  }
  const spread = (saa - (sa * sa) / n) * (sbb - (sb * sb) / n);
  return spread > 0 ? (sab - (sa * sb) / n) / Math.sqrt(spread) : 0;
}

/**
 * For each column the largest size of its correlation with one of the metrics; 1 for metrics.
 * @param {import('./dataset.js').Dataset} dataset
 */
export function influences(dataset) {
  const step = Math.max(1, Math.floor(dataset.count / most));
  const rows = Array.from({ length: Math.ceil(dataset.count / step) }, (_, k) => k * step);
  const metrics = dataset.metricColumns().filter((column) => !dataset.isConstant(column));
  return dataset.columns.map((column, k) =>
    column.metric
      ? 1
      : Math.max(0, ...metrics.map((metric) => Math.abs(correlation(dataset.values(k), dataset.values(metric), rows)))),
  );
}
