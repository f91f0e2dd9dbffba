// Lines that stand out: the Pareto set, the variants looked at and pointed at.

const mostPareto = 400;

/**
 * @param {CanvasRenderingContext2D} context in CSS pixels
 * @param {import('./layout.js').Axis[]} axes
 * @param {(axis: import('./layout.js').Axis, row: number) => number} yOf pixels from the top, or NaN
 */
function polyline(context, axes, yOf, row) {
  let drawing = false;
  for (const axis of axes) {
    const y = yOf(axis, row);
    if (Number.isNaN(y)) drawing = false;
    else if (drawing) context.lineTo(axis.x, y);
    else {
      context.moveTo(axis.x, y);
      drawing = true;
    }
  }
}

/**
 * @param {import('../explorer.js').Explorer} explorer
 * @param {Record<string, string>} theme colours
 */
export function drawMarks(context, axes, yOf, explorer, theme) {
  const stroke = (rows, colour, width, opacity = 1) => {
    if (rows.length === 0) return;
    context.beginPath();
    rows.forEach((row) => polyline(context, axes, yOf, row));
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.globalAlpha = opacity;
    context.lineJoin = 'round';
    context.stroke();
    context.globalAlpha = 1;
  };
  const front =
    explorer.pareto.length <= mostPareto ? [...explorer.pareto].filter((row) => explorer.filter.mask[row]) : [];
  stroke(front, theme.pareto, 1.2, Math.min(0.8, Math.max(0.2, 4 / Math.sqrt(front.length))));
  const one = (row, colour, width) => {
    if (row < 0) return;
    stroke([row], theme.back, width + 2.5);
    stroke([row], colour, width);
  };
  one(explorer.pointed, theme.soft, 1.6);
  one(explorer.pinned, theme.pinned, 2.4);
  one(explorer.chosen, theme.chosen, 2.6);
}
