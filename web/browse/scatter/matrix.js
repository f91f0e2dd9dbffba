// All pairs of a few columns as small scatter plots; a press shows one of them large.
import { element } from '../dom.js';
import { makeScale } from '../scale.js';
import { packed, Points } from './points.js';

const mostColumns = 5,
  gap = 4;

export class ScatterMatrix {
  /**
   * @param {import('../explorer.js').Explorer} explorer
   * @param {import('../frame.js').Frame} frame
   * @param {import('../theme.js').Theme} theme
   * @param {(x: number, y: number) => void} show one pair
   */
  constructor(explorer, frame, theme, show) {
    Object.assign(this, { explorer, frame, theme, show });
    this.canvas = element('canvas', {});
    this.cells = element('div', { class: 'cells' });
    this.root = element('div', { class: 'chart matrix', hidden: true }, this.canvas, this.cells);
    this.draw = () => this.draw_();
    const again = () => this.make();
    explorer.on('filter chosen pinned pointed', () => this.request_());
    explorer.on('columns colour objectives', again);
    theme.onChange(again);
    new ResizeObserver(again).observe(this.root);
  }

  request_() {
    if (!this.root.hidden) this.frame.request(this.draw);
  }

  /** The objectives, then further metrics and variables that have an axis. */
  columns() {
    const { explorer } = this,
      { columns } = explorer.dataset;
    const others = [...explorer.axes].sort((a, b) => Number(columns[b].metric) - Number(columns[a].metric));
    return [...new Set([...explorer.objectives.map(({ column }) => column), ...others])].slice(0, mostColumns);
  }

  /** Places the plots anew. */
  make() {
    const width = this.root.clientWidth,
      height = this.root.clientHeight;
    if (this.root.hidden || width < 80 || height < 80) return;
    const { explorer, theme } = this,
      { dataset, log } = explorer,
      columns = this.columns();
    const density = Math.min(2, devicePixelRatio || 1),
      count = columns.length;
    const across = (width - gap * (count - 1)) / count,
      down = (height - gap * (count - 1)) / count;
    [this.canvas.width, this.canvas.height] = [Math.round(width * density), Math.round(height * density)];
    const scales = columns.map((column) => makeScale(dataset.range(column), log.has(column)));
    const shades = explorer.colour < 0 ? null : theme.shades(explorer, explorer.colour);
    const table = Array.from({ length: 256 }, (_, shade) => packed(theme.palette(shade)));
    const plain = packed(theme.rgb('lines'));
    this.colourOf = shades ? (row) => table[shades[row]] : () => plain;
    this.size = Math.round(density * (dataset.count > 5000 ? 1 : 2));
    this.plots = [];
    this.cells.replaceChildren();
    columns.forEach((y, k) =>
      columns.slice(0, k + 1).forEach((x, j) => {
        const place = { left: j * (across + gap), top: k * (down + gap), width: across, height: down };
        this.cells.append(this.cell_(x, y, place));
        if (j === k) return;
        const [w, h] = [Math.round(across * density), Math.round(down * density)];
        const xs = dataset.values(x),
          ys = dataset.values(y),
          inner = (part, size) => 2 + part * (size - 4);
        this.plots.push({
          left: Math.round(place.left * density),
          top: Math.round(place.top * density),
          points: new Points(
            dataset.count,
            w,
            h,
            (row) => inner(scales[j].place(xs[row]), w),
            (row) => inner(1 - scales[k].place(ys[row]), h),
          ),
        });
      }),
    );
    this.frame.request(this.draw);
  }

  cell_(x, y, place) {
    const { columns } = this.explorer.dataset;
    const cell =
      x === y
        ? element('span', { class: 'name', textContent: columns[x].name })
        : element('button', {
            type: 'button',
            'aria-label': `${columns[y].name} over ${columns[x].name}`,
            title: `${columns[y].name} over ${columns[x].name}`,
            onclick: () => this.show(x, y),
          });
    Object.entries(place).forEach(([side, pixels]) => {
      cell.style[side] = `${pixels}px`;
    });
    return cell;
  }

  draw_() {
    if (this.root.hidden || !this.plots) return;
    const { explorer, theme } = this,
      context = this.canvas.getContext('2d');
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    for (const { left, top, points } of this.plots) {
      context.putImageData(
        points.picture({
          mask: explorer.filter.mask,
          raised: explorer.isPareto,
          size: this.size,
          colour: this.colourOf,
          ghost: packed(theme.rgb('ghost')),
          raisedColour: packed(theme.rgb('pareto')),
        }),
        left,
        top,
      );
      [
        ['pointed', 'soft'],
        ['pinned', 'pinned'],
        ['chosen', 'chosen'],
      ].forEach(([which, colour]) => {
        const row = explorer[which];
        if (row < 0 || points.xs[row] < 0) return;
        context.beginPath();
        context.arc(left + points.xs[row], top + points.ys[row], 4, 0, 2 * Math.PI);
        context.strokeStyle = theme.colours[colour];
        context.lineWidth = 2;
        context.stroke();
      });
    }
  }
}
