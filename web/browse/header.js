// The top of the page: what the store is, how much of it is shown, and what is selected.
import { choices, element, tick } from './dom.js';
import { counted } from './format.js';
import { openPicker } from './picker.js';

/** "small bending and large height". */
const goals = (objectives, columns) =>
  objectives.map(({ column, minimize }) => `${minimize ? 'small' : 'large'} ${columns[column].name}`).join(' and ');

/** What the page does not show of the store; empty when it shows all. */
export function limitsText({ about, count, columns, pareto }) {
  const sentences = [];
  if (count < about.stored) {
    sentences.push(
      `The store holds ${counted(about.stored)} variants; the page shows ${counted(count)}, evenly sampled` +
        `${pareto.length > 0 ? `, with the whole Pareto set of ${goals(about.objectives, columns)}` : ''}.`,
    );
  }
  if (about.stored < about.planned) {
    sentences.push(
      `The study is not complete: ${counted(about.stored)} of ${counted(about.planned)} variants are measured.`,
    );
  }
  return sentences.join(' ');
}

/** Of how many variants the page holds the body. */
function bodiesText({ about, count }, bodies) {
  const number = bodies.rows.length === count ? 'all' : counted(bodies.rows.length);
  return `${number} in 3-D (${about.bodiesKept ? 'nets of the store' : 'built when the page was written'})`;
}

function statusChips(explorer) {
  const { dataset } = explorer,
    { statuses } = dataset.about;
  const counts = statuses.map((_, k) => dataset.status.reduce((sum, status) => sum + (status === k ? 1 : 0), 0));
  const hidden = new Set();
  const present = [...statuses.keys()].filter((k) => counts[k] > 0);
  const chips = present.map((k) =>
    element('button', {
      type: 'button',
      class: 'chip',
      'aria-pressed': 'true',
      textContent: `${statuses[k]} ${counted(counts[k])}`,
      onclick: (event) => {
        if (!hidden.delete(k)) hidden.add(k);
        event.currentTarget.setAttribute('aria-pressed', String(!hidden.has(k)));
        explorer.setCondition('status', hidden.size ? (row) => hidden.has(dataset.status[row]) : null);
      },
    }),
  );
  explorer.on('cleared', () => {
    hidden.clear();
    chips.forEach((chip) => chip.setAttribute('aria-pressed', 'true'));
  });
  return element('span', { class: 'chips', role: 'group', 'aria-label': 'Statuses shown' }, ...chips);
}

/**
 * @param {import('./explorer.js').Explorer} explorer
 * @param {import('./body/bodies.js').Bodies} bodies
 */
export function header(explorer, bodies) {
  const { dataset } = explorer,
    { about } = dataset;
  const count = element('output', { class: 'count', 'aria-live': 'polite' });
  const clear = element('button', { type: 'button', textContent: 'Clear', onclick: () => explorer.clearFilter() });
  const paretoOnly = tick('Pareto set only', false, (on) =>
    explorer.setCondition('pareto', on ? (row) => !explorer.isPareto[row] : null),
  );
  const update = () => {
    count.textContent = `${counted(explorer.filter.count)} of ${counted(dataset.count)} selected`;
    clear.disabled = !explorer.filter.active;
  };
  explorer.on('filter', update);
  explorer.on('cleared', () => {
    paretoOnly.firstChild.checked = false;
  });
  explorer.on('objectives', () => {
    if (paretoOnly.firstChild.checked) explorer.setCondition('pareto', (row) => !explorer.isPareto[row]);
  });
  update();
  const colour = element('span');
  const showColour = () =>
    colour.replaceChildren(
      choices(
        'Colour by',
        [['-1', 'no colours'], ...dataset.columns.map((column, k) => [String(k), `colour: ${column.name}`])],
        String(explorer.colour),
        (column) => explorer.setColour(Number(column)),
      ),
    );
  explorer.on('colour', showColour);
  showColour();
  const limits = limitsText(dataset);
  return element(
    'header',
    {},
    element(
      'div',
      { class: 'title' },
      element('h1', { textContent: about.study }),
      element('span', {
        class: 'soft',
        textContent:
          `${about.store} · ${counted(about.stored)} variants (${about.method}) · ` +
          `${dataset.variableColumns().length} variables · ${dataset.metricColumns().length} metrics · ${bodiesText(dataset, bodies)}`,
      }),
    ),
    ...(about.note ? [element('p', { class: 'soft note', textContent: about.note })] : []),
    ...(limits ? [element('p', { class: 'limits', textContent: limits })] : []),
    element(
      'div',
      { class: 'toolbar' },
      count,
      clear,
      statusChips(explorer),
      paretoOnly,
      colour,
      element('button', { type: 'button', textContent: 'Columns …', onclick: () => openPicker(explorer) }),
    ),
  );
}
