// Where axes stand and how values lie on them.
import { makeScale } from '../scale.js';

const margin = 58,
  leastSpacing = 84;

/**
 * @typedef {{column: number, x: number, scale: import('../scale.js').Scale, flipped: boolean,
 *   up: (value: number) => number, value: (up: number) => number}} Axis up: 0 at the bottom, 1 at the top
 */

/**
 * @param {import('../explorer.js').Explorer} explorer
 * @param {number} available width in pixels
 * @returns {{axes: Axis[], width: number, spacing: number}}
 */
export function layOut(explorer, available) {
  const { dataset, log, flipped } = explorer;
  const gaps = Math.max(1, explorer.axes.length - 1);
  const spacing = Math.max(leastSpacing, Math.floor((available - 2 * margin) / gaps));
  const axes = explorer.axes.map((column, k) => {
    const scale = makeScale(dataset.range(column), log.has(column)),
      turned = flipped.has(column);
    return {
      column,
      x: margin + k * spacing,
      scale,
      flipped: turned,
      up: (value) => (turned ? 1 - scale.place(value) : scale.place(value)),
      value: (up) => scale.value(turned ? 1 - up : up),
    };
  });
  return { axes, width: Math.max(available, 2 * margin + gaps * spacing), spacing };
}

/** Pixels from the top of all rows on an axis; NaN for rows that have no place on it. */
export function placeRows(axis, values, height) {
  const places = new Float32Array(values.length),
    { scale, flipped } = axis,
    bottom = height - 1;
  for (let row = 0; row < values.length; ++row) {
    const place = scale.place(values[row]),
      up = flipped ? 1 - place : place;
    places[row] = up >= -1e-9 && up <= 1 + 1e-9 ? Math.min(bottom, Math.max(0, (1 - up) * bottom)) : NaN;
  }
  return places;
}
