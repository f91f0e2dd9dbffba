// Which columns have an axis: found by name, by what they have to do with the metrics.
import { element, tick } from './dom.js';

/** @param {import('./explorer.js').Explorer} explorer */
export function openPicker(explorer) {
  const { dataset, influence } = explorer;
  const list = element('div', { class: 'list' });
  const search = element('input', {
    type: 'search',
    placeholder: 'find by name',
    'aria-label': 'Find columns by name',
    oninput: () => show(),
  });
  const count = element('span', { class: 'soft' });
  const found = () => {
    const words = search.value.trim().toLowerCase().split(/\s+/);
    return [...dataset.columns.keys()]
      .filter((column) => !(explorer.hideConstant && dataset.isConstant(column)))
      .filter((column) => words.every((word) => dataset.columns[column].name.toLowerCase().includes(word)))
      .sort((a, b) => influence[b] - influence[a] || a - b);
  };
  const toggle = (column, on) => {
    const others = explorer.axes.filter((other) => other !== column);
    explorer.setAxes(on ? [...others, column] : others);
    counts();
  };
  const counts = () => {
    count.textContent = `${explorer.axes.length} of ${dataset.columns.length} shown`;
  };
  const show = () => {
    counts();
    list.replaceChildren(
      ...found().map((column) => {
        const about = dataset.columns[column],
          label = tick('', explorer.axes.includes(column), (on) => toggle(column, on));
        const bar = element('span', { class: 'bar' });
        bar.style.width = `${Math.round(100 * influence[column])}%`;
        label.append(
          element('span', { class: 'name', textContent: about.name }),
          about.metric
            ? element('small', { textContent: 'metric' })
            : element(
                'span',
                { class: 'influence', title: `largest correlation with a metric: ${influence[column].toFixed(2)}` },
                bar,
              ),
        );
        return label;
      }),
    );
  };
  const button = (text, act) =>
    element('button', {
      type: 'button',
      textContent: text,
      onclick: () => {
        act();
        show();
      },
    });
  const dialog = element(
    'dialog',
    { class: 'picker', 'aria-label': 'Columns', onclose: () => dialog.remove() },
    element('h2', { textContent: 'Columns' }),
    element('div', { class: 'row' }, search, count),
    element(
      'div',
      { class: 'row' },
      button('Show all found', () => explorer.setAxes([...new Set([...explorer.axes, ...found()])])),
      button('Hide all found', () => explorer.setAxes(explorer.axes.filter((column) => !found().includes(column)))),
      button('The usual ones', () => explorer.setAxes(explorer.usualAxes())),
    ),
    tick('hide constant columns', explorer.hideConstant, (on) => {
      explorer.hideConstant = on;
      if (on) explorer.setAxes(explorer.axes.filter((column) => !dataset.isConstant(column)));
      show();
    }),
    list,
    element(
      'div',
      { class: 'row end' },
      element('button', { type: 'button', textContent: 'Done', onclick: () => dialog.close() }),
    ),
  );
  show();
  document.body.append(dialog);
  dialog.showModal();
}
