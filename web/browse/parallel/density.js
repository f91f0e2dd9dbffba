// How many lines cross each pixel. Lines are added and taken away again exactly, so that a brush
// that moves costs only the lines that it gains or loses.

export class Density {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    /** Column by column. */
    this.counts = new Int32Array(width * height);
    /** Sum of the shades of the lines, 0 to 255 each. */
    this.shades = new Int32Array(width * height);
  }

  clear() {
    this.counts.fill(0);
    this.shades.fill(0);
  }

  /**
   * A line between two axes.
   * @param {number} left pixels, whole
   * @param {number} right pixels, whole
   * @param {number} from pixels from the top, in [0, height - 1]
   * @param {number} to likewise
   * @param {1 | -1} sign to add or to take away
   * @param {number} shade of the line, whole
   */
  add(left, right, from, to, sign, shade) {
    const { counts, shades, height } = this,
      weighted = sign * shade;
    const slope = (to - from) / (right - left);
    let y = from,
      column = left * height;
    for (let x = left; x < right; ++x, column += height) {
      const next = x + 1 === right ? to : y + slope;
      let low = y | 0,
        high = next | 0;
      if (low > high) [low, high] = [high, low];
      // One pixel, or all that the line passes on its way through the column but the last.
      const end = column + (high > low ? high : low + 1);
      for (let at = column + low; at < end; ++at) {
        counts[at] += sign;
        shades[at] += weighted;
      }
      y = next;
    }
  }

  /** Mean number of lines of the pixels that have any. */
  usual() {
    let sum = 0,
      pixels = 0;
    for (const count of this.counts) {
      sum += count;
      if (count > 0) pixels += 1;
    }
    return sum / Math.max(1, pixels);
  }

  /**
   * The picture: the more lines, the less transparent.
   * @param {(shade: number) => [number, number, number]} colour for mean shades 0 to 255
   * @param {number} faintest opacity of a single line
   */
  picture(colour, faintest) {
    const { width, height, counts, shades } = this;
    const image = new ImageData(width, height),
      pixels = new Uint32Array(image.data.buffer);
    const table = Uint32Array.from({ length: 256 }, (_, shade) => {
      const [red, green, blue] = colour(shade);
      return red | (green << 8) | (blue << 16);
    });
    const full = Math.max(8, 4 * this.usual());
    const opacity = Uint8Array.from({ length: Math.ceil(full) + 1 }, (_, count) =>
      Math.round(255 * Math.min(1, faintest + (1 - faintest) * Math.sqrt(Math.max(0, count - 1) / full))),
    );
    for (let x = 0, at = 0; x < width; ++x) {
      for (let y = 0; y < height; ++y, ++at) {
        const count = counts[at];
        if (count <= 0) continue;
        const alpha = count < opacity.length ? opacity[count] : 255;
        pixels[y * width + x] = (table[(shades[at] / count) | 0] | (alpha << 24)) >>> 0;
      }
    }
    return image;
  }
}
