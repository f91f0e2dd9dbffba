// A body as grids of vertices with normals and mean curvatures.
import { bernstein, faceJet, gregory, jetSize } from './bezier.js';

// Normals and curvatures are taken this far inside a face, in its parameters: corner patches have
// points where they have none.
const inset = 1e-3;
const metre = 1000;

/**
 * What a grid of a number of cells needs of every degree; made once for many bodies.
 * @param {import('./bezier.js').Face[]} faces
 * @param {number} cells of every face in each direction
 */
export function gridTables(faces, cells) {
  const degrees = new Set(faces.flatMap((face) => [face.degreeU, face.degreeV]));
  const edges = Array.from({ length: cells + 1 }, (_, i) => i / cells);
  const inner = edges.map((t) => Math.min(1 - inset, Math.max(inset, t)));
  const bases = (parameters) =>
    new Map([...degrees].map((degree) => [degree, parameters.map((t) => bernstein(degree, t))]));
  return {
    cells,
    edges: bases(edges),
    inner: bases(inner),
    blends: edges.map((u) => edges.map((v) => gregory(u, v))),
    innerBlends: inner.map((u) => inner.map((v) => gregory(u, v))),
  };
}

// Unit normal out of the body and then the area of a unit of parameters into `normal`; returns the
// mean curvature in 1/m, positive for a sphere.
function normalAndCurvature(jet, inward, normal) {
  const [, , , ax, ay, az, bx, by, bz] = jet;
  let x = ay * bz - az * by,
    y = az * bx - ax * bz,
    z = ax * by - ay * bx;
  const size = Math.hypot(x, y, z) || 1;
  x /= size;
  y /= size;
  z /= size;
  const dot = (k) => x * jet[k] + y * jet[k + 1] + z * jet[k + 2];
  const e = ax * ax + ay * ay + az * az,
    f = ax * bx + ay * by + az * bz,
    g = bx * bx + by * by + bz * bz;
  const mean = (e * dot(15) - 2 * f * dot(12) + g * dot(9)) / (2 * (e * g - f * f));
  const side = inward ? -1 : 1;
  normal[0] = side * x;
  normal[1] = side * y;
  normal[2] = side * z;
  normal[3] = size;
  return -side * metre * mean;
}

/**
 * @param {import('./bezier.js').Face[]} faces
 * @param {Float32Array} points of the body, xyz in mm
 * @param {ReturnType<typeof gridTables>} tables
 * @returns {{positions: Float32Array, normals: Float32Array, curvatures: Float32Array, areas: Float32Array}}
 *   of every face (cells + 1)^2 vertices, v fastest; mm, 1/m, and |S_u x S_v| in mm2
 */
export function tessellate(faces, points, tables) {
  const side = tables.cells + 1,
    count = faces.length * side * side;
  const positions = new Float32Array(3 * count),
    normals = new Float32Array(3 * count);
  const curvatures = new Float32Array(count),
    areas = new Float32Array(count);
  const jet = new Float64Array(jetSize),
    normal = [0, 0, 0, 0];
  let at = 0;
  for (const face of faces) {
    const [edgeU, edgeV] = [tables.edges.get(face.degreeU), tables.edges.get(face.degreeV)];
    const [innerU, innerV] = [tables.inner.get(face.degreeU), tables.inner.get(face.degreeV)];
    for (let i = 0; i < side; ++i) {
      for (let j = 0; j < side; ++j, ++at) {
        faceJet(face, points, edgeU[i], edgeV[j], tables.blends[i][j], jet);
        positions.set(jet.subarray(0, 3), 3 * at);
        faceJet(face, points, innerU[i], innerV[j], tables.innerBlends[i][j], jet);
        curvatures[at] = normalAndCurvature(jet, face.inward, normal);
        normals.set(normal.slice(0, 3), 3 * at);
        areas[at] = normal[3];
      }
    }
  }
  return { positions, normals, curvatures, areas };
}

/** Two triangles to a cell of every face that `takes` lets through. */
export function gridTriangles(faces, cells, takes = () => true) {
  const side = cells + 1;
  const indices = [];
  faces.forEach((face, f) => {
    if (!takes(face)) return;
    for (let i = 0; i < cells; ++i) {
      for (let j = 0; j < cells; ++j) {
        const a = f * side * side + i * side + j,
          b = a + side;
        indices.push(a, a + 1, b, b, a + 1, b + 1);
      }
    }
  });
  return new Uint32Array(indices);
}
