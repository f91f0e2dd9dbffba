// The page that `bodyline browse` writes.
import { Bodies } from './body/bodies.js';
import { BodyView } from './body/view.js';
import { Dataset } from './dataset.js';
import { element } from './dom.js';
import { Explorer } from './explorer.js';
import { Frame } from './frame.js';
import { header } from './header.js';
import { ParallelView } from './parallel/view.js';
import { ScatterView } from './scatter/view.js';
import { TableView } from './table/view.js';
import { Theme } from './theme.js';
import { VariantPanel } from './variant/panel.js';
import { WallView } from './wall.js';

const dataset = new Dataset(),
  explorer = new Explorer(dataset);
const frame = new Frame(),
  theme = new Theme(),
  bodies = new Bodies(dataset);

const hint = 'Drag along an axis to select, press it to clear; drag a name to move its axis, press it for more.';
document
  .getElementById('page')
  .replaceChildren(
    header(explorer, bodies),
    element(
      'main',
      {},
      element(
        'section',
        { class: 'card axes', 'aria-label': 'Parallel coordinates' },
        new ParallelView(explorer, frame, theme).root,
        element('p', { class: 'soft hint', textContent: hint }),
      ),
      element(
        'div',
        { class: 'middle' },
        new ScatterView(explorer, frame, theme).root,
        new BodyView(explorer, frame, theme, bodies).root,
        new VariantPanel(explorer).root,
      ),
      element(
        'div',
        { class: 'bottom' },
        new TableView(explorer, frame).root,
        ...(bodies.rows.length > 0 || document.getElementById('pictures')
          ? [new WallView(explorer, frame, theme, bodies).root]
          : []),
      ),
    ),
  );

// The page begins with something to see: the first of the Pareto set, or the first with a body.
const first = [...explorer.pareto, ...bodies.rows].find((row) => bodies.has(row));
if (first !== undefined) explorer.choose(first);
document.documentElement.dataset.ready = 'yes';
