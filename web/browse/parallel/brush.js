// Choosing a range on an axis with the pointer.

const edge = 6; // pixels around an end of a range in which it can be taken

/**
 * What a press at `y` takes of a range from `top` to `bottom`.
 * @returns {'new' | 'top' | 'bottom' | 'all'}
 */
function grip(y, range) {
  if (!range) return 'new';
  if (Math.abs(y - range.top) <= edge) return 'top';
  if (Math.abs(y - range.bottom) <= edge) return 'bottom';
  return y > range.top && y < range.bottom ? 'all' : 'new';
}

/**
 * Ranges are {top, bottom} in pixels, or null.
 * @param {HTMLElement} strip along the axis
 * @param {{height: () => number, get: () => ({top: number, bottom: number} | null),
 *   set: (range: {top: number, bottom: number} | null) => void}} axis
 */
export function brush(strip, { height, get, set }) {
  let pressed = null;
  const inside = (y) => Math.min(height(), Math.max(0, y));
  const placeOf = (event) => event.clientY - strip.getBoundingClientRect().top;
  strip.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    strip.setPointerCapture(event.pointerId);
    const y = placeOf(event),
      range = get();
    pressed = { y, range, grip: grip(y, range), moved: false };
    event.preventDefault();
  });
  strip.addEventListener('pointermove', (event) => {
    const y = inside(placeOf(event));
    if (!pressed) {
      strip.style.cursor = { new: 'crosshair', all: 'grab', top: 'ns-resize', bottom: 'ns-resize' }[grip(y, get())];
      return;
    }
    if (!pressed.moved && Math.abs(y - pressed.y) < 3) return;
    pressed.moved = true;
    set(moved(pressed, y, height()));
  });
  strip.addEventListener('pointerup', () => {
    if (pressed && !pressed.moved) set(null);
    pressed = null;
  });
  strip.addEventListener('pointercancel', () => {
    pressed = null;
  });
}

function moved({ y: start, range, grip: taken }, y, height) {
  if (taken === 'all') {
    const size = range.bottom - range.top;
    const top = Math.min(height - size, Math.max(0, range.top + y - start));
    return { top, bottom: top + size };
  }
  const fixed = taken === 'new' ? start : taken === 'top' ? range.bottom : range.top;
  return { top: Math.min(fixed, y), bottom: Math.max(fixed, y) };
}
