// A layer of lines, one for each row of a mask, drawn little by little so that no frame is late.
import { Density } from './density.js';

const rowsAtOnce = 256;

export class Lines {
  /** @param {HTMLCanvasElement} canvas @param {number} count of rows */
  constructor(canvas, count) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.drawn = new Uint8Array(count);
    this.density = new Density(1, 1);
    this.axes = [];
    this.shade = null;
    this.next = 0;
  }

  /**
   * Begins anew.
   * @param {{x: number, y: Float32Array}[]} axes from left to right; pixels
   * @param {Uint8Array | null} shade of each row
   */
  begin(width, height, axes, shade) {
    if (this.density.width !== width || this.density.height !== height) {
      this.density = new Density(width, height);
      this.canvas.width = width;
      this.canvas.height = height;
    } else {
      this.density.clear();
    }
    this.axes = axes;
    this.shade = shade;
    this.drawn.fill(0);
    this.next = 0;
  }

  /** Draws towards a mask for some milliseconds; true when more is to be done. */
  advance(mask, milliseconds) {
    const { drawn } = this,
      count = drawn.length,
      end = performance.now() + milliseconds;
    let left = count,
      changed = 0;
    while (left > 0) {
      const row = this.next;
      if (drawn[row] !== mask[row]) {
        this.drawRow_(row, mask[row] ? 1 : -1);
        drawn[row] = mask[row];
        if (++changed % rowsAtOnce === 0 && performance.now() > end) break;
      }
      this.next = row + 1 === count ? 0 : row + 1;
      --left;
    }
    this.changed = changed > 0;
    return left > 0;
  }

  show(colour, faintest) {
    this.context.putImageData(this.density.picture(colour, faintest), 0, 0);
  }

  drawRow_(row, sign) {
    const { axes, density } = this,
      shade = this.shade ? this.shade[row] : 0;
    for (let k = 0; k + 1 < axes.length; ++k) {
      const from = axes[k].y[row],
        to = axes[k + 1].y[row];
      if (from === from && to === to) density.add(axes[k].x, axes[k + 1].x, from, to, sign, shade);
    }
  }
}
