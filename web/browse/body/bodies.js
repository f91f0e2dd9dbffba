// The bodies that the page holds: nets of some variants, and what is drawn of them.
import { placeFaces } from '../../surface/bezier.js';
import { gridTables, gridTriangles, tessellate } from '../../surface/tessellate.js';
import { takeNumbers } from '../decode.js';

const mostKept = 8; // tessellations

export class Bodies {
  /** @param {import('../dataset.js').Dataset} dataset */
  constructor(dataset) {
    this.faces = placeFaces(dataset.about.faces);
    this.size = 3 * dataset.about.bodyPoints;
    this.rows = takeNumbers('body-rows', Int32Array);
    this.points = takeNumbers('body-points', Float32Array);
    this.places = new Map(Array.from(this.rows, (row, place) => [row, place]));
    this.frame = frameOf(this.points);
    this.grids = new Map();
    this.kept = new Map();
  }

  has(row) {
    return this.places.has(row);
  }

  /** Points of all faces of a row's body, xyz in mm. */
  net(row) {
    const place = this.places.get(row);
    return this.points.subarray(place * this.size, (place + 1) * this.size);
  }

  /** Tables and triangles of grids with so many cells to a face and direction. */
  grid(cells) {
    if (!this.grids.has(cells)) {
      this.grids.set(cells, {
        tables: gridTables(this.faces, cells),
        whole: gridTriangles(this.faces, cells),
        mirrored: gridTriangles(this.faces, cells, (face) => !face.central),
      });
    }
    return this.grids.get(cells);
  }

  /** A row's body as grids of vertices. */
  surface(row, cells) {
    const key = `${row} ${cells}`,
      kept = this.kept.get(key) ?? tessellate(this.faces, this.net(row), this.grid(cells).tables);
    this.kept.delete(key);
    this.kept.set(key, kept);
    if (this.kept.size > mostKept) this.kept.delete(this.kept.keys().next().value);
    return kept;
  }
}

// A common frame for all bodies, so that sizes can be compared; centred in the plane of symmetry.
function frameOf(points) {
  const least = [Infinity, Infinity, Infinity],
    most = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < points.length; ++k) {
    const axis = k % 3;
    least[axis] = Math.min(least[axis], points[k]);
    most[axis] = Math.max(most[axis], points[k]);
  }
  const centre = [0, 2].map((axis) => 0.5 * (least[axis] + most[axis]));
  const reach = Math.max(Math.abs(least[1]), Math.abs(most[1]));
  const half = Math.hypot(0.5 * (most[0] - least[0]), reach, 0.5 * (most[2] - least[2]));
  return { centre: [centre[0], 0, centre[1]], half: half > 0 ? half : 1 };
}
