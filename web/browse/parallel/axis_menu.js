// The menu of an axis: everything that the pointer can do there, and more, for the keyboard.
import { element, tick } from '../dom.js';
import { titled } from '../format.js';

/**
 * Opens a dialog for a column.
 * @param {import('../explorer.js').Explorer} explorer
 * @param {number} column
 * @param {HTMLElement} near where it opens; gets the focus back
 */
export function openAxisMenu(explorer, column, near) {
  const { dataset, filter } = explorer;
  const about = dataset.columns[column],
    range = filter.ranges.get(column) ?? ['', ''];
  const toggle = (set, on) => {
    if (on) set.add(column);
    else set.delete(column);
    explorer.emit('columns');
  };
  const limit = (label, value) =>
    element('input', {
      type: 'number',
      step: 'any',
      value,
      'aria-label': label,
      placeholder: label,
    });
  const least = limit('least', range[0]),
    most = limit('most', range[1]);
  const apply = () => {
    const low = least.value === '' ? -Infinity : Number(least.value);
    const high = most.value === '' ? Infinity : Number(most.value);
    explorer.setRange(column, least.value === '' && most.value === '' ? null : [low, high]);
  };
  [least, most].forEach((input) => input.addEventListener('change', apply));
  const move = (step) => {
    const axes = [...explorer.axes],
      at = axes.indexOf(column),
      to = at + step;
    if (to < 0 || to >= axes.length) return;
    [axes[at], axes[to]] = [axes[to], axes[at]];
    explorer.setAxes(axes);
  };
  const button = (text, act) => element('button', { type: 'button', textContent: text, onclick: act });
  const close = () => dialog.close();
  const dialog = element(
    'dialog',
    { class: 'menu', 'aria-label': about.name },
    element('strong', { textContent: titled(about) }),
    element('div', { class: 'row' }, least, '–', most),
    tick('Logarithmic', explorer.log.has(column), (on) => toggle(explorer.log, on)),
    tick('Turned over', explorer.flipped.has(column), (on) => toggle(explorer.flipped, on)),
    element(
      'div',
      { class: 'row' },
      button('← Move', () => move(-1)),
      button('Move →', () => move(1)),
    ),
    element(
      'div',
      { class: 'row' },
      button('Colour by it', () => explorer.setColour(explorer.colour === column ? -1 : column)),
      button('Hide', () => {
        explorer.setAxes(explorer.axes.filter((other) => other !== column));
        close();
      }),
    ),
    element(
      'div',
      { class: 'row' },
      button('Clear range', () => {
        least.value = most.value = '';
        explorer.setRange(column, null);
      }),
      button('Close', close),
    ),
  );
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) close();
  });
  dialog.addEventListener('close', () => {
    dialog.remove();
    near.focus?.();
  });
  document.body.append(dialog);
  dialog.showModal();
  const box = near.getBoundingClientRect();
  dialog.style.left = `${Math.max(8, Math.min(innerWidth - dialog.offsetWidth - 8, box.left))}px`;
  dialog.style.top = `${Math.min(innerHeight - dialog.offsetHeight - 8, box.bottom + 4)}px`;
}
