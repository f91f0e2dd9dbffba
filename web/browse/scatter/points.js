// Points of all rows, stamped into a picture.

const none = -32768;

/** Packs a colour for a picture of little-endian pixels. */
export function packed([red, green, blue], alpha = 255) {
  return (red | (green << 8) | (blue << 16) | (alpha << 24)) >>> 0;
}

/** Where rows are in a picture; rows without a place are left out. */
export class Points {
  /** @param {(row: number) => number} x pixels @param {(row: number) => number} y pixels from the top */
  constructor(count, width, height, x, y) {
    Object.assign(this, { count, width, height });
    this.xs = new Int16Array(count);
    this.ys = new Int16Array(count);
    for (let row = 0; row < count; ++row) {
      const left = x(row),
        top = y(row);
      const inside = left >= 0 && left <= width && top >= 0 && top <= height;
      this.xs[row] = inside ? Math.round(left) : none;
      this.ys[row] = inside ? Math.round(top) : none;
    }
  }

  /**
   * The picture: unselected rows faint, then the selected ones, then those that stand out.
   * @param {{mask: Uint8Array, raised: Uint8Array, size: number, ghost: number, raisedColour: number,
   *   colour: (row: number) => number}} style colours packed
   */
  picture({ mask, raised, size, ghost, raisedColour, colour }) {
    const image = new ImageData(Math.max(1, this.width), Math.max(1, this.height));
    const pixels = new Uint32Array(image.data.buffer);
    for (let row = 0; row < this.count; ++row) {
      if (!mask[row]) this.stamp_(pixels, row, size, ghost);
    }
    for (let row = 0; row < this.count; ++row) {
      if (mask[row] && !raised[row]) this.stamp_(pixels, row, size, colour(row));
    }
    for (let row = 0; row < this.count; ++row) {
      if (mask[row] && raised[row]) this.stamp_(pixels, row, size + 2, raisedColour);
    }
    return image;
  }

  /** The row of a mask nearest to a place, within some pixels, or -1. */
  nearest(left, top, mask, reach) {
    let found = -1,
      least = reach * reach;
    for (let row = 0; row < this.count; ++row) {
      const away = (this.xs[row] - left) ** 2 + (this.ys[row] - top) ** 2;
      if (mask[row] && away < least) [found, least] = [row, away];
    }
    return found;
  }

  // A square, moved into the picture where it would stand out of it.
  stamp_(pixels, row, size, colour) {
    const { width, height } = this,
      x = this.xs[row];
    if (x === none) return;
    const left = Math.max(0, Math.min(width - size, x - (size >> 1)));
    const top = Math.max(0, Math.min(height - size, this.ys[row] - (size >> 1)));
    for (let y = 0, at = top * width + left; y < size; ++y, at += width) {
      for (let across = 0; across < size; ++across) pixels[at + across] = colour;
    }
  }
}
