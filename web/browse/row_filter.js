// Which rows are selected: those in all ranges, of a chosen status.

export class RowFilter {
  /** @param {import('./dataset.js').Dataset} dataset */
  constructor(dataset) {
    this.dataset = dataset;
    /** By column: [least, most]. @type {Map<number, [number, number]>} */
    this.ranges = new Map();
    /** @type {Map<number | string, Uint8Array>} 1 where a condition is broken */
    this.broken_ = new Map();
    this.failures_ = new Uint8Array(dataset.count);
    /** 1 where a row is selected. */
    this.mask = new Uint8Array(dataset.count).fill(1);
    this.count = dataset.count;
  }

  get active() {
    return this.broken_.size > 0;
  }

  /** Rows whose value is no number are in no range. `range` null: any value. */
  setRange(column, range) {
    if (range) this.ranges.set(column, range);
    else this.ranges.delete(column);
    if (!range) {
      this.replace_(column, null);
      return;
    }
    const [least, most] = range,
      values = this.dataset.values(column);
    this.replace_(column, (row) => !(values[row] >= least && values[row] <= most));
  }

  /** @param {string} name of a condition @param {((row: number) => boolean) | null} breaks */
  setCondition(name, breaks) {
    this.replace_(name, breaks);
  }

  clear() {
    this.ranges.clear();
    [...this.broken_.keys()].forEach((key) => this.replace_(key, null));
  }

  /** Selected rows, rising. */
  rows() {
    const rows = new Int32Array(this.count);
    let at = 0;
    for (let row = 0; row < this.mask.length; ++row) {
      if (this.mask[row]) rows[at++] = row;
    }
    return rows;
  }

  replace_(key, breaks) {
    const { failures_: failures, mask } = this;
    const before = this.broken_.get(key) ?? new Uint8Array(mask.length);
    let count = 0;
    for (let row = 0; row < mask.length; ++row) {
      const broken = breaks && breaks(row) ? 1 : 0;
      failures[row] += broken - before[row];
      before[row] = broken;
      mask[row] = failures[row] === 0 ? 1 : 0;
      count += mask[row];
    }
    this.count = count;
    if (breaks) this.broken_.set(key, before);
    else this.broken_.delete(key);
  }
}
