// The names above the axes: press for the menu, drag to reorder.
import { breakable, element } from '../dom.js';
import { openAxisMenu } from './axis_menu.js';

const most = 112; // pixels; the outermost ones stay within the margin

/**
 * @param {import('../explorer.js').Explorer} explorer
 * @param {import('./layout.js').Axis} axis
 * @param {number} spacing
 */
export function heading(explorer, axis, spacing) {
  const about = explorer.dataset.columns[axis.column];
  const button = element(
    'button',
    {
      type: 'button',
      class: about.metric ? 'heading metric' : 'heading',
      title: `${about.name}: drag to move, press for more`,
      'data-column': String(axis.column),
      'aria-haspopup': 'dialog',
    },
    element('span', {}, ...breakable(about.name)),
  );
  if (about.unit && about.unit !== '1') button.append(element('small', { textContent: about.unit }));
  button.style.left = `${axis.x}px`;
  button.style.width = `${Math.min(spacing - 6, most)}px`;
  drag(button, explorer, axis, spacing);
  return button;
}

function drag(button, explorer, axis, spacing) {
  let start = null;
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    start = { x: event.clientX, moved: false };
    button.setPointerCapture(event.pointerId);
  });
  button.addEventListener('pointermove', (event) => {
    if (!start) return;
    const step = event.clientX - start.x;
    if (Math.abs(step) > 4) start.moved = true;
    if (start.moved) button.style.transform = `translateX(calc(-50% + ${step}px))`;
  });
  button.addEventListener('pointerup', (event) => {
    if (!start?.moved) return;
    const axes = [...explorer.axes],
      at = axes.indexOf(axis.column);
    const to = Math.min(axes.length - 1, Math.max(0, at + Math.round((event.clientX - start.x) / spacing)));
    axes.splice(at, 1);
    axes.splice(to, 0, axis.column);
    explorer.setAxes(axes);
  });
  button.addEventListener('pointercancel', () => {
    start = null;
    button.style.transform = '';
  });
  button.addEventListener('click', () => {
    if (!start?.moved) openAxisMenu(explorer, axis.column, button);
    start = null;
  });
}
