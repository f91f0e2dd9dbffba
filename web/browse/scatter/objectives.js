// What should be small or large: the objectives of the Pareto set.
import { choices, element } from '../dom.js';
import { counted } from '../format.js';

/** @param {import('../explorer.js').Explorer} explorer */
export function objectivesPanel(explorer) {
  const { dataset } = explorer;
  const list = element('div', { class: 'objectives' });
  const note = element('span', { class: 'soft' });
  const set = (objectives) => {
    explorer.setObjectives(objectives);
    show();
  };
  const change = (at, part) => set(explorer.objectives.map((old, k) => (k === at ? { ...old, ...part } : old)));
  const chip = ({ column, minimize }, at) =>
    element(
      'span',
      { class: 'chip' },
      element('button', {
        type: 'button',
        textContent: minimize ? 'small' : 'large',
        'aria-label': `${dataset.columns[column].name} should be ${minimize ? 'small' : 'large'}; press to turn over`,
        onclick: () => change(at, { minimize: !minimize }),
      }),
      dataset.columns[column].name,
      element('button', {
        type: 'button',
        textContent: '×',
        'aria-label': `no objective: ${dataset.columns[column].name}`,
        onclick: () => set(explorer.objectives.filter((_, k) => k !== at)),
      }),
    );
  const adder = () => {
    const free = [...dataset.metricColumns(), ...dataset.variableColumns()].filter(
      (column) => !explorer.objectives.some((objective) => objective.column === column),
    );
    return choices(
      'Add an objective',
      [['', 'add …'], ...free.map((column) => [String(column), dataset.columns[column].name])],
      '',
      (column) => column !== '' && set([...explorer.objectives, { column: Number(column), minimize: true }]),
    );
  };
  const show = () => {
    list.replaceChildren(
      element('span', { class: 'label', textContent: 'Pareto set of' }),
      ...explorer.objectives.map(chip),
      adder(),
      note,
    );
    note.textContent =
      explorer.objectives.length < 2
        ? 'give two objectives'
        : `${counted(explorer.pareto.length)} variants${isSampled(explorer) ? ' of those shown' : ''}`;
  };
  show();
  return list;
}

// The whole store's Pareto set is in a sample for the objectives that the page was made with.
function isSampled({ dataset, objectives }) {
  const made = JSON.stringify(dataset.about.objectives);
  return dataset.about.shown < dataset.about.stored && JSON.stringify(objectives) !== made;
}
