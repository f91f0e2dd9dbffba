// A scatter plot of two columns; dragging a box selects, a press chooses.
import UPlot from 'uplot';
import { choices, element, tabs, tick } from '../dom.js';
import { short, titled } from '../format.js';
import { makeScale } from '../scale.js';
import { ScatterMatrix } from './matrix.js';
import { objectivesPanel } from './objectives.js';
import { packed, Points } from './points.js';

const tickSpacing = [80, 45]; // pixels across and up
const reach = 12; // pixels around a point in which it is found

export class ScatterView {
  /**
   * @param {import('../explorer.js').Explorer} explorer
   * @param {import('../frame.js').Frame} frame
   * @param {import('../theme.js').Theme} theme
   */
  constructor(explorer, frame, theme) {
    Object.assign(this, { explorer, frame, theme });
    const first = [...explorer.dataset.metricColumns(), ...explorer.dataset.variableColumns()];
    const [x, y] = explorer.objectives.map(({ column }) => column);
    this.x = x ?? first[0];
    this.y = y ?? first[1] ?? first[0];
    this.host = element('div', { class: 'chart' });
    this.pair = element('div', { class: 'pair' });
    this.controls = element('div', { class: 'controls' }, this.pair);
    this.matrix = new ScatterMatrix(explorer, frame, theme, (x, y) => {
      this.show(x, y);
      this.setMatrix_(false);
    });
    this.root = element(
      'section',
      { class: 'card scatter', 'aria-label': 'Scatter plot' },
      this.controls,
      this.host,
      this.matrix.root,
      objectivesPanel(explorer),
    );
    this.layer = document.createElement('canvas');
    this.draw = () => {
      if (!this.host.hidden) this.plot?.redraw(false, false);
    };
    explorer.on('filter chosen pinned pointed objectives', () => frame.request(this.draw));
    explorer.on('colour', () => this.make());
    explorer.on('columns', () => {
      this.showControls_();
      this.make();
    });
    theme.onChange(() => this.make());
    new ResizeObserver(() => this.make()).observe(this.host);
    this.showControls_();
    this.setMatrix_(false);
  }

  // One plot, or a matrix of small ones.
  setMatrix_(on) {
    this.host.hidden = on;
    this.pair.hidden = on;
    this.matrix.root.hidden = !on;
    this.modes?.remove();
    this.modes = tabs(
      'Scatter plots',
      [
        ['one', 'Plot'],
        ['all', 'Matrix'],
      ],
      on ? 'all' : 'one',
      (mode) => this.setMatrix_(mode === 'all'),
    );
    this.controls.prepend(this.modes);
    if (on) this.matrix.make();
    else this.make();
  }

  /** Shows two columns. */
  show(x, y) {
    [this.x, this.y] = [x, y];
    this.showControls_();
    this.make();
  }

  make() {
    const width = this.host.clientWidth,
      height = this.host.clientHeight;
    if (width < 80 || height < 80) return;
    this.plot?.destroy();
    const { dataset, log } = this.explorer;
    this.scales = [this.x, this.y].map((column) => makeScale(dataset.range(column), log.has(column)));
    this.points = null;
    const ends = this.scales.map(({ least, most }) => [least, most]);
    this.plot = new UPlot(this.options_(width, height), ends, this.host);
  }

  options_(width, height) {
    const { columns } = this.explorer.dataset,
      { soft, line } = this.theme.colours;
    const scale = ({ least, most, log }) => {
      const margin = log ? 1 : 0.02 * (most - least);
      return {
        time: false,
        auto: false,
        distr: log ? 3 : 1,
        range: log ? [least, most] : [least - margin, most + margin],
      };
    };
    const axis = (column, side, ticks) => ({
      side,
      stroke: soft,
      grid: { stroke: line, width: 1 },
      ticks: { show: false },
      size: side === 3 ? 58 : 34,
      label: titled(columns[column]),
      labelSize: 20,
      labelFont: '12px system-ui',
      font: '11px system-ui',
      labelGap: 2,
      splits: () => ticks,
      filter: (_, splits) => splits,
      values: (_, splits) => splits.map((value) => (value === null ? '' : short(value, 12))),
    });
    return {
      width,
      height,
      padding: [10, 14, 0, 0],
      legend: { show: false },
      scales: { x: scale(this.scales[0]), y: scale(this.scales[1]) },
      series: [{}, { paths: () => null, points: { show: false } }],
      axes: [
        axis(this.x, 2, this.scales[0].ticks(width / tickSpacing[0])),
        axis(this.y, 3, this.scales[1].ticks(height / tickSpacing[1])),
      ],
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: true, setScale: false, dist: 4 } },
      hooks: {
        draw: [(plot) => this.drawPoints_(plot)],
        setSelect: [(plot) => this.select_(plot)],
        setCursor: [(plot) => this.explorer.point(this.rowAt_(plot))],
        ready: [
          (plot) =>
            plot.over.addEventListener('click', () => {
              const row = this.rowAt_(plot);
              if (row >= 0) this.explorer.choose(row);
            }),
        ],
      },
    };
  }

  rowAt_(plot) {
    const { left, top } = plot.cursor,
      density = UPlot.pxRatio;
    if (!this.points || left < 0) return -1;
    return this.points.nearest(left * density, top * density, this.explorer.filter.mask, reach * density);
  }

  select_(plot) {
    const { left, top, width, height } = plot.select;
    if (width < 2 || height < 2) return;
    const { explorer } = this;
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    explorer.filter.setRange(this.x, [plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x')]);
    explorer.setRange(this.y, [plot.posToVal(top + height, 'y'), plot.posToVal(top, 'y')]);
  }

  drawPoints_(plot) {
    const { explorer, theme, layer } = this,
      { left, top, width, height } = plot.bbox;
    const { count } = explorer.dataset;
    if (!this.points) {
      const [xs, ys] = [this.x, this.y].map((column) => explorer.dataset.values(column));
      this.points = new Points(
        count,
        Math.round(width),
        Math.round(height),
        (row) => plot.valToPos(xs[row], 'x', true) - left,
        (row) => plot.valToPos(ys[row], 'y', true) - top,
      );
      const shades = explorer.colour < 0 ? null : theme.shades(explorer, explorer.colour);
      const table = Array.from({ length: 256 }, (_, shade) => packed(theme.palette(shade)));
      const plain = packed(theme.rgb('lines'));
      this.colourOf = shades ? (row) => table[shades[row]] : () => plain;
    }
    const density = UPlot.pxRatio,
      size = Math.round(density * (count > 5000 ? 2 : count > 800 ? 3 : 4));
    const image = this.points.picture({
      mask: explorer.filter.mask,
      raised: explorer.isPareto,
      size,
      colour: this.colourOf,
      ghost: packed(theme.rgb('ghost')),
      raisedColour: packed(theme.rgb('pareto')),
    });
    [layer.width, layer.height] = [image.width, image.height];
    layer.getContext('2d').putImageData(image, 0, 0);
    plot.ctx.save();
    plot.ctx.drawImage(layer, left, top);
    [
      ['pointed', 'soft'],
      ['pinned', 'pinned'],
      ['chosen', 'chosen'],
    ].forEach(([which, colour]) => this.ring_(plot.ctx, explorer[which], theme.colours[colour], left, top, density));
    plot.ctx.restore();
  }

  ring_(context, row, colour, left, top, density) {
    if (row < 0 || this.points.xs[row] < 0) return;
    const x = left + this.points.xs[row],
      y = top + this.points.ys[row];
    [
      [this.theme.colours.back, 4.5],
      [colour, 2.5],
    ].forEach(([stroke, width]) => {
      context.beginPath();
      context.arc(x, y, 6 * density, 0, 2 * Math.PI);
      context.strokeStyle = stroke;
      context.lineWidth = width * density;
      context.stroke();
    });
  }

  showControls_() {
    const { explorer } = this,
      { dataset } = explorer;
    const entries = [...dataset.metricColumns(), ...dataset.variableColumns()].map((column) => [
      String(column),
      dataset.columns[column].name,
    ]);
    const log = (column) =>
      tick('log', explorer.log.has(column), (on) => {
        if (on) explorer.log.add(column);
        else explorer.log.delete(column);
        explorer.emit('columns');
      });
    this.pair.replaceChildren(
      element(
        'label',
        {},
        '↔ ',
        choices('Column across', entries, String(this.x), (x) => this.show(Number(x), this.y)),
      ),
      log(this.x),
      element(
        'label',
        {},
        '↕ ',
        choices('Column up', entries, String(this.y), (y) => this.show(this.x, Number(y))),
      ),
      log(this.y),
    );
  }
}
