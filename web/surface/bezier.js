// Points and derivatives of a face from its net, as model/surface.hpp defines them.

/**
 * A face of a body: where its points stand among those of the body, v fastest.
 * @typedef {{name: string, degreeU: number, degreeV: number, blend: boolean, central: boolean,
 *   inward: boolean, first: number}} Face
 */

/**
 * Values, first and second derivatives of the Bernstein polynomials of a degree at t.
 * @returns {number[][]} three rows of degree + 1 numbers
 */
export function bernstein(degree, t) {
  /** @type {number[][]} */
  const rows = [[1]];
  for (let n = 1; n <= degree; ++n) {
    const last = rows[n - 1];
    rows.push(Array.from({ length: n + 1 }, (_, i) => (1 - t) * (last[i] ?? 0) + t * (last[i - 1] ?? 0)));
  }
  const lower = rows[degree - 1] ?? [0],
    lowest = rows[degree - 2] ?? [];
  const at = (row, i) => row[i] ?? 0;
  const first = rows[degree].map((_, i) => degree * (at(lower, i - 1) - at(lower, i)));
  const second = rows[degree].map(
    (_, i) => degree * (degree - 1) * (at(lowest, i - 2) - 2 * at(lowest, i - 1) + at(lowest, i)),
  );
  return [rows[degree], first, second];
}

/**
 * The Gregory function g = p(u) p(v) (u^2 - v^2) / (u^2 + v^2), p(t) = t (1 - t)^2, with its
 * derivatives by u, v, uu, uv, vv; 0 at the corner (0, 0).
 */
export function gregory(u, v) {
  const s = u * u + v * v;
  if (s === 0) return [0, 0, 0, 0, 0, 0];
  const p = (t) => [t * (1 - t) ** 2, (1 - t) * (1 - 3 * t), 6 * t - 4];
  const [p0, p1, p2] = p(u),
    [q0, q1, q2] = p(v);
  const r = (u * u - v * v) / s,
    ru = (4 * u * v * v) / s ** 2,
    rv = (-4 * u * u * v) / s ** 2;
  const ruu = (4 * v * v * (v * v - 3 * u * u)) / s ** 3;
  const ruv = (8 * u * v * (u * u - v * v)) / s ** 3;
  const rvv = (-4 * u * u * (u * u - 3 * v * v)) / s ** 3;
  return [
    p0 * q0 * r,
    q0 * (p1 * r + p0 * ru),
    p0 * (q1 * r + q0 * rv),
    q0 * (p2 * r + 2 * p1 * ru + p0 * ruu),
    p1 * q1 * r + p1 * q0 * rv + p0 * q1 * ru + p0 * q0 * ruv,
    p0 * (q2 * r + 2 * q1 * rv + q0 * rvv),
  ];
}

/** How many numbers a jet has: S, Su, Sv, Suu, Suv, Svv, three each. */
export const jetSize = 18;
// Of each: the order of the derivative in u and in v.
const orders = [
  [0, 0],
  [1, 0],
  [0, 1],
  [2, 0],
  [1, 1],
  [0, 2],
];

/**
 * The jet of a face where its Bernstein polynomials have the values `bu` and `bv`.
 * @param {Face} face
 * @param {Float32Array} points of the body, xyz
 * @param {number[][]} bu of bernstein
 * @param {number[][]} bv of bernstein
 * @param {number[]} g of gregory; not used for a polynomial face
 * @param {Float64Array} out jetSize numbers
 */
export function faceJet(face, points, bu, bv, g, out) {
  out.fill(0);
  const columns = face.degreeV + 1;
  for (let i = 0; i <= face.degreeU; ++i) {
    for (let j = 0; j <= face.degreeV; ++j) {
      const at = 3 * (face.first + i * columns + j);
      for (let k = 0; k < orders.length; ++k) {
        const weight = bu[orders[k][0]][i] * bv[orders[k][1]][j];
        out[3 * k] += weight * points[at];
        out[3 * k + 1] += weight * points[at + 1];
        out[3 * k + 2] += weight * points[at + 2];
      }
    }
  }
  if (!face.blend) return;
  const at = 3 * (face.first + (face.degreeU + 1) * columns);
  for (let k = 0; k < orders.length; ++k) {
    for (let c = 0; c < 3; ++c) out[3 * k + c] += g[k] * points[at + c];
  }
}

/** The faces with the places of their points, which follow each other; see explore/browse_bodies.hpp. */
export function placeFaces(faces) {
  let first = 0;
  return faces.map((face) => {
    const placed = { ...face, first };
    first += (face.degreeU + 1) * (face.degreeV + 1) + (face.blend ? 1 : 0);
    return placed;
  });
}
