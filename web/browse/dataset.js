// The variants of the page, column by column. Rows are places in the page, ids numbers in the store.
import { readJson, takeNumbers } from './decode.js';

/**
 * @typedef {{name: string, unit: string, kind: string, metric: boolean, least: number | null,
 *   most: number | null, start?: number}} Column
 */

export class Dataset {
  constructor() {
    this.about = readJson('description');
    /** @type {Column[]} */
    this.columns = this.about.columns;
    this.ids = takeNumbers('ids', Float64Array);
    this.status = takeNumbers('status', Uint8Array);
    this.cause = takeNumbers('cause', Uint16Array);
    this.pareto = takeNumbers('pareto', Int32Array);
    this.count = this.ids.length;
    /** @type {Float64Array[]} */
    this.values_ = [];
    this.ranges_ = [];
  }

  /** All values of a column; decoded when they are first asked for. */
  values(column) {
    return (this.values_[column] ??= takeNumbers(`column-${column}`, Float64Array));
  }

  /** Least, least positive and largest finite value of a column; none: least > most. */
  range(column) {
    return (this.ranges_[column] ??= rangeOf(this.values(column)));
  }

  isConstant(column) {
    const { least, most } = this.range(column);
    return !(least < most);
  }

  /** The row of a variant of the store, or -1. */
  rowOf(id) {
    let low = 0,
      high = this.count - 1;
    while (low <= high) {
      const middle = (low + high) >> 1;
      if (this.ids[middle] === id) return middle;
      if (this.ids[middle] < id) low = middle + 1;
      else high = middle - 1;
    }
    return -1;
  }

  /** "valid", or with its cause "folded (hood)". */
  statusText(row) {
    const cause = this.about.causes[this.cause[row]];
    return this.about.statuses[this.status[row]] + (cause ? ` (${cause})` : '');
  }

  metricColumns() {
    return this.columns.flatMap((column, k) => (column.metric ? [k] : []));
  }

  variableColumns() {
    return this.columns.flatMap((column, k) => (column.metric ? [] : [k]));
  }
}

function rangeOf(values) {
  let least = Infinity,
    leastPositive = Infinity,
    most = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < least) least = value;
    if (value > 0 && value < leastPositive) leastPositive = value;
    if (value > most) most = value;
  }
  return { least, leastPositive, most };
}
