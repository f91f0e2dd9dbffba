// The chosen variant in three dimensions, alone or beside the one it is compared with.
import { home, Stage } from '../../surface/stage.js';
import { turntable } from '../../surface/turntable.js';
import { element, tabs } from '../dom.js';
import { short } from '../format.js';
import { nearestOf } from '../neighbours.js';
import { Drawing } from './drawing.js';

const cells = 16;

export class BodyView {
  /**
   * @param {import('../explorer.js').Explorer} explorer
   * @param {import('../frame.js').Frame} frame
   * @param {import('../theme.js').Theme} theme
   * @param {import('./bodies.js').Bodies} bodies
   */
  constructor(explorer, frame, theme, bodies) {
    Object.assign(this, { explorer, frame, theme, bodies, look: 'paint', layout: 'side', view: { ...home } });
    this.canvas = element('canvas', {
      tabIndex: 0,
      'aria-label': 'The chosen variant in three dimensions: drag or use the arrow keys to turn it',
    });
    this.message = element('div', { class: 'message' });
    this.labels = element('div', { class: 'labels' });
    this.legend = element('div', { class: 'legend' });
    this.layouts = tabs(
      'Arrangement of two variants',
      [
        ['side', 'Apart'],
        ['over', 'Overlaid'],
      ],
      'side',
      (layout) => {
        this.layout = layout;
        this.compose();
      },
    );
    const look = tabs(
      'Colours',
      [
        ['paint', 'Paint'],
        ['zebra', 'Zebra'],
        ['curvature', 'Curvature'],
        ['difference', 'Difference'],
      ],
      'paint',
      (chosen) => {
        this.look = chosen;
        this.compose();
      },
    );
    this.root = element(
      'section',
      { class: 'card body', 'aria-label': 'Three dimensions' },
      element('div', { class: 'controls' }, element('h2', { textContent: 'In 3-D' }), look, this.layouts),
      element('div', { class: 'stage' }, this.canvas, this.labels, this.message),
      this.legend,
    );
    this.draw = () => this.draw_();
    turntable(this.canvas, this.view, () => frame.request(this.draw));
    explorer.on('chosen pinned', () => this.compose());
    new ResizeObserver(() => {
      if (this.stage) frame.request(this.draw);
    }).observe(this.canvas);
    this.compose();
  }

  /** Makes the scenes anew. */
  compose() {
    const { explorer, bodies } = this,
      { chosen, pinned } = explorer;
    const rows = [chosen, pinned].filter((row, k, all) => row >= 0 && bodies.has(row) && all.indexOf(row) === k);
    const shown = bodies.has(chosen) && this.makeStage_() ? rows : [];
    this.layouts.hidden = shown.length < 2;
    this.canvas.hidden = shown.length === 0;
    this.say_(shown);
    this.scenes = null;
    if (shown.length > 0)
      Object.assign(this, this.drawing.scenes(shown, { look: this.look, layout: this.layout, cells }));
    this.showLabels_(shown);
    this.showLegend_(shown);
    this.frame.request(this.draw);
  }

  // Whether there is a stage; made when it is first needed, null without WebGL.
  makeStage_() {
    if (this.stage === undefined) {
      try {
        this.stage = new Stage(this.canvas);
        this.drawing = new Drawing(this.bodies, this.theme.diverging);
      } catch {
        this.stage = null;
      }
    }
    return this.stage !== null;
  }

  draw_() {
    if (!this.scenes || this.canvas.clientWidth === 0) return;
    if (this.stage.width !== this.canvas.clientWidth || this.stage.height !== this.canvas.clientHeight)
      this.stage.fit();
    this.stage.draw(this.scenes, this.view);
    const apart = this.scenes.length === 2;
    this.labels.classList.toggle('stacked', apart && this.stage.isStacked(2));
    this.labels.classList.toggle('two', apart && !this.stage.isStacked(2));
  }

  showLabels_(rows) {
    const { dataset } = this.explorer,
      name = (row) => `#${dataset.ids[row]}`;
    this.labels.replaceChildren(
      ...rows.map((row, k) => element('span', { class: k ? 'pinned' : 'chosen', textContent: name(row) })),
    );
  }

  showLegend_(rows) {
    const { map, theme } = this;
    const hint =
      this.look === 'difference' && rows.length < 2 && rows.length > 0
        ? 'Compare two variants to see their difference.'
        : '';
    if (!map || rows.length === 0) {
      this.legend.replaceChildren(hint);
      return;
    }
    const bar = element('span', { class: 'bar' });
    bar.style.background = theme.gradient((part) => theme.divergingColour(part));
    const what =
      this.look === 'difference'
        ? 'outside of the other variant, at the same parameters'
        : 'mean curvature, red bulges outwards';
    this.legend.replaceChildren(short(-map.range, 3), bar, `${short(map.range, 3)} ${map.unit}: ${what}`);
  }

  // Why there is nothing to see.
  say_(shown) {
    const { explorer, bodies, message } = this,
      { chosen, dataset } = explorer;
    message.hidden = shown.length > 0;
    if (shown.length > 0) return;
    const status = dataset.about.statuses[dataset.status[chosen]];
    if (this.stage === null)
      message.replaceChildren('This browser has no WebGL, which the view in three dimensions needs.');
    else if (chosen < 0) message.replaceChildren('Choose a variant: press a line, a point or a row.');
    else if (['cut_order', 'fullness', 'lean'].includes(status)) {
      message.replaceChildren(`Variant ${dataset.ids[chosen]} cannot be built: ${dataset.statusText(chosen)}.`);
    } else if (bodies.rows.length === 0) message.replaceChildren('This page was written without bodies (--bodies 0).');
    else message.replaceChildren(...this.offerNearest_(chosen));
  }

  offerNearest_(chosen) {
    const { explorer, bodies } = this,
      { dataset } = explorer;
    const like = nearestOf(dataset, chosen, dataset.variableColumns(), bodies.rows);
    const text =
      `The page holds the bodies of ${bodies.rows.length} of ${dataset.count} variants, not that of variant ` +
      `${dataset.ids[chosen]}. Write it with --bodies for more. `;
    return [
      text,
      element('button', {
        type: 'button',
        textContent: `Show #${dataset.ids[like]}, the nearest by variables`,
        onclick: () => explorer.choose(like),
      }),
    ];
  }
}
