// What the user has chosen; all views follow it. Events: filter, chosen, pinned, pointed,
// objectives, colour, columns.
import { paretoSet } from './pareto.js';
import { RowFilter } from './row_filter.js';
import { influences } from './influence.js';

const usualColumns = 12;

export class Explorer extends EventTarget {
  /** @param {import('./dataset.js').Dataset} dataset */
  constructor(dataset) {
    super();
    this.dataset = dataset;
    this.filter = new RowFilter(dataset);
    this.influence = influences(dataset);
    /** Columns of the parallel axes, from left to right. @type {number[]} */
    this.axes = this.usualAxes();
    this.log = new Set();
    this.flipped = new Set();
    this.hideConstant = true;
    /** Rows, or -1: looked at, compared with, under the pointer. */
    this.chosen = this.pinned = this.pointed = -1;
    /** Column that colours lines and points, or -1. */
    this.colour = -1;
    /** @type {{column: number, minimize: boolean}[]} */
    this.objectives = dataset.about.objectives;
    this.setPareto_(dataset.pareto);
  }

  emit(name) {
    this.dispatchEvent(new Event(name));
  }

  on(names, listen) {
    names.split(' ').forEach((name) => this.addEventListener(name, listen));
  }

  /** Metrics, and the variables that have most to do with them. */
  usualAxes() {
    const moving = (column) => !this.dataset.isConstant(column);
    const metrics = this.dataset.metricColumns().filter(moving).slice(0, usualColumns);
    const variables = this.dataset
      .variableColumns()
      .filter(moving)
      .sort((a, b) => this.influence[b] - this.influence[a])
      .slice(0, Math.max(4, usualColumns - metrics.length))
      .sort((a, b) => a - b);
    const moved = [...variables, ...metrics];
    return moved.length > 0 ? moved : [...this.dataset.columns.keys()].slice(-usualColumns);
  }

  setRange(column, range) {
    this.filter.setRange(column, range);
    this.emit('filter');
  }

  setCondition(name, breaks) {
    this.filter.setCondition(name, breaks);
    this.emit('filter');
  }

  clearFilter() {
    this.filter.clear();
    this.emit('cleared');
    this.emit('filter');
  }

  choose(row) {
    if (row === this.chosen) return;
    this.chosen = row;
    this.emit('chosen');
  }

  pin(row) {
    this.pinned = row;
    this.emit('pinned');
  }

  point(row) {
    if (row === this.pointed) return;
    this.pointed = row;
    this.emit('pointed');
  }

  setAxes(axes) {
    this.axes = axes;
    this.emit('columns');
  }

  setColour(column) {
    this.colour = column;
    this.emit('colour');
  }

  /** Finds the Pareto set of the valid rows anew; fewer than two objectives have none. */
  setObjectives(objectives) {
    this.objectives = objectives;
    const { dataset } = this;
    const valid = Int32Array.from(dataset.ids.keys()).filter((row) => dataset.status[row] === 0);
    this.setPareto_(
      objectives.length < 2
        ? []
        : paretoSet(
            objectives.map(({ column }) => dataset.values(column)),
            objectives.map(({ minimize }) => minimize),
            valid,
          ),
    );
    this.emit('objectives');
  }

  setPareto_(rows) {
    this.pareto = rows;
    this.isPareto = new Uint8Array(this.dataset.count);
    rows.forEach((row) => {
      this.isPareto[row] = 1;
    });
  }
}
