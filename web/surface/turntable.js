// Turns a view with pointer, wheel and keys.
import { home } from './stage.js';

const least = 0.6,
  most = 6;

/**
 * @param {HTMLCanvasElement} canvas that can have the focus
 * @param {typeof home} view is changed
 * @param {() => void} redraw
 */
export function turntable(canvas, view, redraw) {
  const turn = (right, up) => {
    view.azimuth -= right;
    view.elevation = Math.min(89, Math.max(-89, view.elevation + up));
    redraw();
  };
  const zoomBy = (factor) => {
    view.zoom = Math.min(most, Math.max(least, view.zoom * factor));
    redraw();
  };
  /** @type {PointerEvent | null} */
  let last = null;
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture((last = event).pointerId));
  canvas.addEventListener('pointermove', (event) => {
    if (!(event.buttons & 1) || !last) return;
    turn(0.35 * (event.clientX - last.clientX), 0.35 * (event.clientY - last.clientY));
    last = event;
  });
  canvas.addEventListener(
    'wheel',
    (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      zoomBy(Math.exp(-0.004 * event.deltaY));
    },
    { passive: false },
  );
  canvas.addEventListener('dblclick', () => {
    Object.assign(view, home);
    redraw();
  });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] }[event.key];
    if (step) {
      event.preventDefault();
      turn(...step);
    }
    if (event.key === '+') zoomBy(1.15);
    if (event.key === '-') zoomBy(1 / 1.15);
  });
}
