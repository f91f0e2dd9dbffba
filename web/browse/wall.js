// Small pictures of many variants: those that the store keeps, else drawn here from their bodies.
import { element } from './dom.js';
import { home, Stage } from '../surface/stage.js';
import { Drawing } from './body/drawing.js';
import { readJson } from './decode.js';
import { short } from './format.js';

const width = 176,
  height = 99,
  cells = 6;
const density = Math.min(2, window.devicePixelRatio || 1);

export class WallView {
  /**
   * @param {import('./explorer.js').Explorer} explorer
   * @param {import('./frame.js').Frame} frame
   * @param {import('./theme.js').Theme} theme
   * @param {import('./body/bodies.js').Bodies} bodies
   */
  constructor(explorer, frame, theme, bodies) {
    Object.assign(this, { explorer, frame, theme, bodies });
    this.pictures = document.getElementById('pictures') ? readJson('pictures') : {};
    const rows = [...new Set([...Object.keys(this.pictures).map(Number), ...bodies.rows])].sort((a, b) => a - b);
    this.note = element('span', { class: 'soft' });
    this.grid = element('div', { class: 'wall' });
    this.root = element(
      'section',
      { class: 'card walled', 'aria-label': 'Pictures' },
      element('div', { class: 'controls' }, element('h2', { textContent: 'Pictures' }), this.note),
      this.grid,
    );
    this.tiles = new Map(rows.map((row) => [row, this.tile_(row)]));
    this.grid.append(...this.tiles.values());
    this.watcher = new IntersectionObserver(
      (entries) =>
        entries.forEach((entry) => {
          if (entry.isIntersecting) this.paint_(Number(entry.target.dataset.row));
        }),
      { rootMargin: '200px' },
    );
    this.tiles.forEach((tile) => this.watcher.observe(tile));
    /** Rows whose tiles are to be drawn. @type {number[]} */
    this.waiting = [];
    this.paintNext = () => this.paintNext_();
    this.mark = () => this.mark_();
    explorer.on('filter', () => frame.later(this.mark));
    explorer.on('chosen pinned objectives', () => frame.request(this.mark));
    this.mark_();
  }

  tile_(row) {
    const { explorer } = this,
      { dataset } = explorer,
      id = dataset.ids[row];
    const picture = this.pictures[row]
      ? element('img', { src: `data:image/png;base64,${this.pictures[row]}`, alt: '' })
      : element('canvas', { width: width * density, height: height * density });
    const metric = dataset.metricColumns()[0];
    const caption = metric === undefined ? '' : ` ${short(dataset.values(metric)[row], 4)}`;
    return element(
      'button',
      {
        type: 'button',
        class: 'tile',
        'data-row': String(row),
        'aria-label': `Variant ${id}`,
        onclick: () => explorer.choose(row),
        onpointerenter: () => explorer.point(row),
        onpointerleave: () => explorer.point(-1),
      },
      picture,
      element('span', {}, element('b', { textContent: `#${id}` }), caption),
    );
  }

  mark_() {
    const { explorer } = this;
    let count = 0;
    this.tiles.forEach((tile, row) => {
      tile.hidden = !explorer.filter.mask[row];
      count += tile.hidden ? 0 : 1;
      tile.classList.toggle('chosen', row === explorer.chosen);
      tile.classList.toggle('pinned', row === explorer.pinned);
      tile.classList.toggle('pareto', explorer.isPareto[row] === 1);
    });
    const metric = explorer.dataset.metricColumns()[0];
    this.note.textContent = `${count} of the selected variants have a picture${
      metric === undefined ? '' : `; the number is ${explorer.dataset.columns[metric].name}`
    }.`;
  }

  // Draws a tile when it comes into sight.
  paint_(row) {
    const canvas = this.tiles.get(row).querySelector('canvas');
    if (!canvas || canvas.dataset.done) return;
    canvas.dataset.done = 'yes';
    this.waiting.push(row);
    this.frame.request(this.paintNext);
  }

  // One tile to a frame; true when more wait.
  paintNext_() {
    const row = this.waiting.shift(),
      stage = this.stage_();
    if (!stage || row === undefined) return false;
    const { scenes } = this.drawing.scenes([row], { look: 'paint', layout: 'side', cells });
    stage.draw(scenes, home);
    const canvas = this.tiles.get(row).querySelector('canvas');
    canvas.getContext('2d').drawImage(stage.canvas, 0, 0, canvas.width, canvas.height);
    return this.waiting.length > 0;
  }

  stage_() {
    if (this.stage === undefined) {
      try {
        this.stage = new Stage(document.createElement('canvas'));
        this.stage.fit(width, height);
        this.drawing = new Drawing(this.bodies, this.theme.diverging);
      } catch {
        this.stage = null;
      }
    }
    return this.stage;
  }
}
