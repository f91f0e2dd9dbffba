// Colours of the drawings, from the style sheet, light or dark as the system is.
import { takeBytes } from './decode.js';
import { makeScale } from './scale.js';

const names = ['ink', 'soft', 'line', 'back', 'panel', 'accent', 'ghost', 'lines', 'pareto', 'chosen', 'pinned'];

export class Theme {
  constructor() {
    const steps = takeBytes('scale-colours');
    this.steps = steps;
    /** RGB bytes for values from -1 to 1. */
    this.diverging = takeBytes('map-colours');
    this.dark = matchMedia('(prefers-color-scheme: dark)');
    /** Colour of a shade from 0 to 255; the ends that are hard to see on the page are left out. */
    this.palette = (shade) => {
      const part = this.dark.matches ? 0.2 + (0.8 * shade) / 255 : (0.88 * shade) / 255;
      const at = 3 * Math.round(part * (steps.length / 3 - 1));
      return [steps[at], steps[at + 1], steps[at + 2]];
    };
    this.read_();
  }

  onChange(listen) {
    this.dark.addEventListener('change', () => {
      this.read_();
      listen();
    });
  }

  /** A named colour as red, green and blue. */
  rgb(name) {
    const text = this.colours[name].replace('#', '');
    return [0, 2, 4].map((at) => parseInt(text.slice(at, at + 2), 16));
  }

  /** Of each row a shade by its value in a column. */
  shades(explorer, column) {
    const { dataset } = explorer;
    const scale = makeScale(dataset.range(column), explorer.log.has(column));
    return Uint8Array.from(dataset.values(column), (value) =>
      Math.round(255 * Math.min(1, Math.max(0, scale.place(value) || 0))),
    );
  }

  /** A CSS gradient of a palette given by a function from 0 to 1 to colours. */
  gradient(colour) {
    const stops = Array.from({ length: 9 }, (_, k) => `rgb(${colour(k / 8).join(' ')})`);
    return `linear-gradient(90deg, ${stops.join(', ')})`;
  }

  divergingColour(part) {
    const at = 3 * Math.round(part * (this.diverging.length / 3 - 1));
    return [...this.diverging.subarray(at, at + 3)];
  }

  read_() {
    const style = getComputedStyle(document.documentElement);
    this.colours = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  }
}
