// All numbers of the chosen variant, its neighbours, and what can be done with it.
import { breakable, choices, element } from '../dom.js';
import { exact, short } from '../format.js';
import { nearest } from '../neighbours.js';
import { openCopyDialog } from './copy.js';

const neighbourCount = 8;

export class VariantPanel {
  /** @param {import('../explorer.js').Explorer} explorer */
  constructor(explorer) {
    this.explorer = explorer;
    this.near = 'variables';
    this.search = element('input', {
      type: 'search',
      placeholder: 'find a column',
      'aria-label': 'Find a column of the variant',
      oninput: () => this.showNumbers_(),
    });
    this.title = element('div', { class: 'controls' });
    this.numbers = element('div', { class: 'numbers' });
    this.neighbours = element('div', { class: 'neighbours' });
    this.root = element(
      'section',
      { class: 'card variant', 'aria-label': 'Chosen variant' },
      this.title,
      this.neighbours,
      this.search,
      this.numbers,
    );
    explorer.on('chosen pinned', () => this.show());
    explorer.on('objectives', () => this.showTitle_());
    this.show();
  }

  show() {
    this.showTitle_();
    this.showNeighbours_();
    this.showNumbers_();
  }

  showTitle_() {
    const { explorer } = this,
      { chosen, pinned, dataset } = explorer;
    this.search.hidden = chosen < 0;
    if (chosen < 0) {
      this.title.replaceChildren(
        element('h2', { textContent: 'Variant' }),
        element('span', { class: 'soft', textContent: 'none chosen' }),
      );
      return;
    }
    const button = (text, act, title) => element('button', { type: 'button', textContent: text, title, onclick: act });
    const status = dataset.statusText(chosen) + (explorer.isPareto[chosen] ? ', in the Pareto set' : '');
    this.title.replaceChildren(
      element('h2', { class: 'chosen', textContent: `#${dataset.ids[chosen]}` }),
      element('span', { class: 'soft status', textContent: status }),
      pinned === chosen
        ? element('span', { class: 'soft', textContent: 'pinned' })
        : button('Compare', () => explorer.pin(chosen), 'Keep it in view, to compare others with it'),
      ...(pinned >= 0
        ? [button(`Unpin #${dataset.ids[pinned]}`, () => explorer.pin(-1), 'No longer compare with it')]
        : []),
      button('Copy …', () => openCopyDialog(dataset, chosen), 'Copy its variables as a model'),
    );
  }

  showNumbers_() {
    const { explorer } = this,
      { chosen, pinned, dataset } = explorer;
    if (chosen < 0) {
      this.numbers.replaceChildren();
      return;
    }
    const compared = pinned >= 0 && pinned !== chosen ? pinned : -1;
    const wanted = this.search.value.trim().toLowerCase();
    const line = (column) => {
      const about = dataset.columns[column],
        values = dataset.values(column);
      return element(
        'tr',
        { 'data-column': String(column) },
        element('th', { title: about.name }, ...breakable(about.name)),
        element(
          'td',
          {},
          element('div', { class: 'value', textContent: exact(values[chosen]) }),
          ...(compared < 0 ? [] : [element('div', { class: 'pinned', textContent: exact(values[compared]) })]),
        ),
        element('td', { class: 'unit', textContent: about.unit === '1' ? '' : about.unit }),
      );
    };
    const table = (columns) =>
      element(
        'table',
        {},
        element(
          'tbody',
          {},
          ...columns.filter((column) => dataset.columns[column].name.toLowerCase().includes(wanted)).map(line),
        ),
      );
    this.numbers.replaceChildren(
      element('h3', { textContent: 'Metrics' }),
      table(dataset.metricColumns()),
      element('h3', { textContent: 'Variables' }),
      table(dataset.variableColumns()),
    );
  }

  showNeighbours_() {
    const { explorer } = this,
      { chosen, dataset } = explorer;
    if (chosen < 0) {
      this.neighbours.replaceChildren();
      return;
    }
    const columns = this.near === 'variables' ? dataset.variableColumns() : dataset.metricColumns();
    const list = nearest(dataset, chosen, columns, neighbourCount).map(({ row, distance }) =>
      element(
        'button',
        {
          type: 'button',
          title: `root mean square difference ${exact(distance)} of the ranges`,
          'data-id': String(dataset.ids[row]),
          onclick: () => explorer.choose(row),
          onpointerenter: () => explorer.point(row),
          onpointerleave: () => explorer.point(-1),
        },
        `#${dataset.ids[row]}`,
        element('small', { textContent: ` ${short(100 * distance, 2)} %` }),
      ),
    );
    this.neighbours.replaceChildren(
      element(
        'span',
        { class: 'label' },
        'Nearest by ',
        choices(
          'Nearest by',
          [
            ['variables', 'variables'],
            ['metrics', 'metrics'],
          ],
          this.near,
          (near) => {
            this.near = near;
            this.showNeighbours_();
          },
        ),
      ),
      ...list,
    );
  }
}
