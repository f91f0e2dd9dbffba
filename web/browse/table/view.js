// A table of the selected variants; only the rows in sight exist.
import { element, tick } from '../dom.js';
import { counted, exact, short, titled } from '../format.js';
import { csvOf, save } from './csv.js';
import { orderBy, selectedInOrder } from './order.js';

const rowHeight = 28,
  spare = 6;

export class TableView {
  /**
   * @param {import('../explorer.js').Explorer} explorer
   * @param {import('../frame.js').Frame} frame
   */
  constructor(explorer, frame) {
    Object.assign(this, { explorer, frame, sort: { column: -1, falling: false }, allDigits: false });
    this.order = orderBy(explorer.dataset.ids, false);
    this.head = element('div', { class: 'tr head', role: 'row' });
    this.body = element('div', { class: 'tbody', role: 'rowgroup' });
    this.scroll = element(
      'div',
      {
        class: 'table',
        role: 'grid',
        tabIndex: 0,
        'aria-label': 'Selected variants',
        onscroll: () => this.request_(),
        onkeydown: (event) => this.key_(event),
      },
      this.head,
      this.body,
    );
    this.exporter = element('button', { type: 'button', class: 'export', onclick: () => this.export_() });
    this.root = element(
      'section',
      { class: 'card tabled', 'aria-label': 'Table' },
      element(
        'div',
        { class: 'controls' },
        element('h2', { textContent: 'Variants' }),
        this.exporter,
        tick('all digits', false, (on) => {
          this.allDigits = on;
          this.columns_();
        }),
      ),
      this.scroll,
    );
    this.draw = () => this.draw_();
    explorer.on('columns', () => this.columns_());
    explorer.on('filter', () => this.rows_());
    explorer.on('pinned objectives', () => this.request_());
    explorer.on('chosen', () => this.reveal_());
    new ResizeObserver(() => this.request_()).observe(this.scroll);
    this.columns_();
    this.rows_();
  }

  request_() {
    this.frame.request(this.draw);
  }

  /** Sorts by a column, -1 for the id; the other way round when it is sorted by it already. */
  sortBy(column) {
    const falling = this.sort.column === column && !this.sort.falling;
    this.sort = { column, falling };
    const { dataset } = this.explorer;
    this.order = orderBy(column < 0 ? dataset.ids : dataset.values(column), falling);
    this.columns_();
    this.rows_();
    this.request_();
  }

  columns_() {
    const { explorer, sort } = this,
      { dataset } = explorer;
    const variables = explorer.axes.filter((column) => !dataset.columns[column].metric);
    this.shown = [...dataset.metricColumns(), ...variables];
    const head = (column, text) =>
      element(
        'button',
        {
          type: 'button',
          class: 'th',
          role: 'columnheader',
          title: text,
          onclick: () => this.sortBy(column),
          'aria-sort': sort.column !== column ? 'none' : sort.falling ? 'descending' : 'ascending',
        },
        element('span', { textContent: text }),
        sort.column === column ? (sort.falling ? ' ↓' : ' ↑') : '',
      );
    this.head.replaceChildren(
      head(-1, 'id'),
      element('span', { class: 'th status', role: 'columnheader', textContent: 'status' }),
      ...this.shown.map((column) => head(column, titled(dataset.columns[column]))),
    );
    const width = this.allDigits ? 168 : 112;
    this.scroll.style.setProperty('--columns', `72px 132px repeat(${this.shown.length}, ${width}px)`);
    this.request_();
  }

  rows_() {
    const { filter } = this.explorer;
    this.stale = true;
    this.frame.later(this.draw);
    this.exporter.textContent = `Export ${counted(filter.count)} as CSV`;
    this.exporter.disabled = filter.count === 0;
  }

  draw_() {
    const { explorer, scroll, body } = this;
    if (this.stale) {
      this.rows = selectedInOrder(this.order, explorer.filter.mask, explorer.filter.count);
      this.stale = false;
      body.style.height = `${this.rows.length * rowHeight}px`;
    }
    if (scroll.clientHeight === 0) return;
    const first = Math.max(0, Math.floor(scroll.scrollTop / rowHeight) - spare);
    const last = Math.min(this.rows.length, first + Math.ceil(scroll.clientHeight / rowHeight) + 2 * spare);
    body.replaceChildren(...Array.from(this.rows.subarray(first, last), (row, k) => this.row_(row, first + k)));
  }

  row_(row, place) {
    const { explorer } = this,
      { dataset } = explorer;
    const marks = [
      row === explorer.chosen && 'chosen',
      row === explorer.pinned && 'pinned',
      explorer.isPareto[row] && 'pareto',
    ].filter(Boolean);
    const made = element(
      'div',
      {
        class: ['tr', ...marks].join(' '),
        role: 'row',
        'aria-selected': String(row === explorer.chosen),
        'data-id': String(dataset.ids[row]),
        onclick: () => explorer.choose(row),
        onpointerenter: () => explorer.point(row),
        onpointerleave: () => explorer.point(-1),
      },
      element('span', { role: 'gridcell', textContent: String(dataset.ids[row]) }),
      element('span', {
        role: 'gridcell',
        class: 'status',
        textContent: dataset.statusText(row),
        title: dataset.statusText(row),
      }),
    );
    made.style.top = `${place * rowHeight}px`;
    for (const column of this.shown) {
      const value = dataset.values(column)[row];
      made.append(
        element('span', {
          role: 'gridcell',
          textContent: this.allDigits ? exact(value) : short(value, 6),
          title: exact(value),
        }),
      );
    }
    return made;
  }

  key_(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step || this.rows.length === 0) return;
    event.preventDefault();
    const at = this.rows.indexOf(this.explorer.chosen);
    const to = at < 0 ? 0 : Math.min(this.rows.length - 1, Math.max(0, at + step));
    this.explorer.choose(this.rows[to]);
  }

  // Scrolls the chosen row into sight.
  reveal_() {
    this.request_();
    const at = this.rows ? this.rows.indexOf(this.explorer.chosen) : -1;
    if (at < 0) return;
    const top = at * rowHeight,
      { scrollTop, clientHeight } = this.scroll,
      sight = clientHeight - 2 * rowHeight;
    if (top < scrollTop) this.scroll.scrollTop = top;
    else if (top > scrollTop + sight) this.scroll.scrollTop = top - sight;
  }

  export_() {
    const { dataset, filter } = this.explorer;
    const rows = selectedInOrder(this.order, filter.mask, filter.count);
    save(`${dataset.about.study}-selection.csv`, csvOf(dataset, rows), 'text/csv');
  }
}
