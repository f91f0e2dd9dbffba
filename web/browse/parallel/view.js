// Parallel coordinates: brushes, headings, and layers of lines.
import { element } from '../dom.js';
import { short } from '../format.js';
import { brush } from './brush.js';
import { heading } from './headings.js';
import { layOut, placeRows } from './layout.js';
import { Lines } from './lines.js';
import { drawMarks } from './marks.js';

const lineTime = 6; // milliseconds of a frame for lines
const mostSharp = 10000; // rows that are drawn with all pixels of a fine screen
const mostWidth = 16000; // pixels of a canvas that every browser draws
const tickSpacing = 44;

export class ParallelView {
  /**
   * @param {import('../explorer.js').Explorer} explorer
   * @param {import('../frame.js').Frame} frame
   * @param {import('../theme.js').Theme} theme
   */
  constructor(explorer, frame, theme) {
    Object.assign(this, { explorer, frame, theme });
    const canvas = (name) => element('canvas', { class: name });
    this.ghost = new Lines(canvas('ghost'), explorer.dataset.count);
    this.lines = new Lines(canvas('lines'), explorer.dataset.count);
    this.marks = canvas('marks');
    this.plot = element('div', { class: 'plot' }, this.ghost.canvas, this.lines.canvas, this.marks);
    this.inner = element('div', { class: 'inner' }, this.plot);
    this.root = element(
      'div',
      {
        class: 'parallel',
        role: 'group',
        'aria-label': 'Parallel coordinates of the variants',
      },
      this.inner,
    );
    this.all = new Uint8Array(explorer.dataset.count).fill(1);
    this.draw = () => this.draw_();
    const again = () => this.layOut();
    explorer.on('columns', again);
    explorer.on('colour', again);
    explorer.on('filter', () => {
      this.placeRanges_();
      this.request_();
    });
    explorer.on('chosen pinned pointed objectives', () => this.request_());
    theme.onChange(again);
    new ResizeObserver(() => {
      if (this.root.clientWidth !== this.width || this.plot.clientHeight !== this.height) this.layOut();
    }).observe(this.root);
    this.plot.addEventListener('pointermove', (event) => {
      if (event.buttons === 0) explorer.point(this.rowAt_(event));
    });
    this.plot.addEventListener('pointerleave', () => explorer.point(-1));
    this.plot.addEventListener('click', (event) => {
      const row = this.rowAt_(event);
      if (row >= 0 && !event.target.closest('.strip')) explorer.choose(row);
    });
  }

  /** Places everything and draws all lines anew. */
  layOut() {
    const { explorer } = this;
    this.width = this.root.clientWidth;
    this.height = this.plot.clientHeight;
    if (!this.width || !this.height) return;
    const { axes, width, spacing } = layOut(explorer, this.width);
    this.axes = axes;
    this.inner.style.width = `${width}px`;
    [...this.inner.querySelectorAll('.heading')].forEach((old) => old.remove());
    [...this.plot.querySelectorAll('.axis')].forEach((old) => old.remove());
    this.inner.prepend(...axes.map((axis) => heading(explorer, axis, spacing)));
    this.plot.append(...axes.map((axis) => this.axisElement_(axis)));
    this.sharpness = Math.min(2, devicePixelRatio || 1, mostWidth / width);
    this.density = explorer.dataset.count > mostSharp ? Math.min(1, this.sharpness) : this.sharpness;
    const pixels = [Math.round(width * this.density), Math.round(this.height * this.density)];
    const scaled = axes.map((axis) => ({
      x: Math.round(axis.x * this.density),
      y: placeRows(axis, explorer.dataset.values(axis.column), pixels[1]),
    }));
    axes.forEach((axis, k) => {
      axis.rows = scaled[k].y;
    });
    this.ghost.begin(...pixels, scaled, null);
    this.lines.begin(...pixels, scaled, this.shades_());
    [this.marks.width, this.marks.height] = [width, this.height].map((size) => Math.round(size * this.sharpness));
    this.placeRanges_();
    this.request_();
  }

  request_() {
    this.frame.request(this.draw);
  }

  // Colours of the lines: of each row a number of the palette.
  shades_() {
    const { explorer } = this;
    return explorer.colour < 0 ? null : this.theme.shades(explorer, explorer.colour);
  }

  draw_() {
    const { explorer, ghost, lines, theme } = this;
    if (!this.axes) return false;
    let more = lines.advance(explorer.filter.mask, lineTime);
    if (lines.changed) {
      const plain = theme.rgb('lines');
      const faintest = Math.min(0.85, Math.max(0.1, 8 / Math.sqrt(explorer.filter.count + 1)));
      lines.show(explorer.colour < 0 ? () => plain : theme.palette, faintest);
    }
    const filtered = explorer.filter.active;
    ghost.canvas.hidden = !filtered;
    if (filtered && !more) {
      more = ghost.advance(this.all, lineTime);
      if (ghost.changed) ghost.show(() => theme.rgb('ghost'), 0.1);
    }
    this.drawMarks_();
    return more;
  }

  drawMarks_() {
    const context = this.marks.getContext('2d'),
      density = this.sharpness;
    context.setTransform(density, 0, 0, density, 0, 0);
    context.clearRect(0, 0, this.marks.width, this.marks.height);
    drawMarks(context, this.axes, (axis, row) => axis.rows[row] / this.density, this.explorer, this.theme.colours);
  }

  axisElement_(axis) {
    const { explorer } = this;
    const range = element('div', { class: 'range' });
    const strip = element('div', { class: 'strip', 'data-column': String(axis.column) }, range);
    const made = element('div', { class: 'axis' }, strip);
    made.style.left = `${axis.x}px`;
    axis.scale.ticks(Math.floor(this.height / tickSpacing)).forEach((value) => {
      const mark = element('span', { class: 'mark', textContent: short(value, 12) });
      mark.style.top = `${100 * (1 - axis.up(value))}%`;
      made.append(mark);
    });
    axis.range = range;
    brush(strip, {
      height: () => this.height,
      get: () => this.pixelsOf_(axis),
      set: (pixels) => explorer.setRange(axis.column, pixels && this.valuesOf_(axis, pixels)),
    });
    return made;
  }

  valuesOf_(axis, { top, bottom }) {
    const at = (y) => axis.value(1 - y / this.height);
    const [a, b] = [at(top), at(bottom)];
    return [Math.min(a, b), Math.max(a, b)];
  }

  pixelsOf_(axis) {
    const range = this.explorer.filter.ranges.get(axis.column);
    if (!range) return null;
    const inside = range.map((value) => Math.min(axis.scale.most, Math.max(axis.scale.least, value)));
    const ends = inside.map((value) => this.height * (1 - axis.up(value)));
    return { top: Math.min(...ends), bottom: Math.max(...ends) };
  }

  placeRanges_() {
    (this.axes ?? []).forEach((axis) => {
      const pixels = this.pixelsOf_(axis);
      axis.range.hidden = !pixels;
      if (!pixels) return;
      axis.range.style.top = `${pixels.top}px`;
      axis.range.style.height = `${Math.max(2, pixels.bottom - pixels.top)}px`;
    });
  }

  // The selected row whose line passes nearest to the pointer, within a few pixels.
  rowAt_(event) {
    const { axes } = this,
      box = this.plot.getBoundingClientRect();
    const x = event.clientX - box.left,
      y = event.clientY - box.top;
    const k = (axes ?? []).findIndex((axis, at) => at + 1 < axes.length && x >= axis.x && x < axes[at + 1].x);
    if (k < 0) return -1;
    const t = (x - axes[k].x) / (axes[k + 1].x - axes[k].x),
      mask = this.explorer.filter.mask;
    const [left, right] = [axes[k].rows, axes[k + 1].rows];
    let found = -1,
      least = 6;
    for (let row = 0; row < mask.length; ++row) {
      if (!mask[row]) continue;
      const away = Math.abs((left[row] + t * (right[row] - left[row])) / this.density - y);
      if (away < least) [found, least] = [row, away];
    }
    return found;
  }
}
