// What the colours of a body can show.

const share = 0.9; // of the area that lies within the colours

// The size that values do not exceed on most of the area, as a round number.
function rangeOf(lists, surfaces) {
  const sizes = lists
    .flatMap((list, k) => Array.from(list, (value, at) => [Math.abs(value), surfaces[k].areas[at]]))
    .filter(([size]) => Number.isFinite(size))
    .sort((a, b) => a[0] - b[0]);
  const total = sizes.reduce((sum, [, area]) => sum + area, 0);
  let below = 0;
  const size = sizes.find(([, area]) => (below += area) >= share * total)?.[0] ?? 0;
  if (!(size > 1e-9)) return 1;
  const power = 10 ** Math.floor(Math.log10(size));
  return [1, 1.5, 2, 3, 5, 7, 10].find((lead) => lead * power >= size) * power;
}

const scaled = (values, range) => values.map((value) => value / range);

/** Mean curvatures of some bodies, over a common range in 1/m. */
export function curvatureMap(surfaces) {
  const range = rangeOf(
    surfaces.map(({ curvatures }) => curvatures),
    surfaces,
  );
  return { range, unit: '1/m', values: surfaces.map(({ curvatures }) => scaled(curvatures, range)) };
}

/** How far each point of a body lies outside of the point of another with the same parameters, mm. */
export function differences(surface, other) {
  return Float32Array.from(surface.curvatures.keys(), (k) => {
    let sum = 0;
    for (let c = 3 * k; c < 3 * k + 3; ++c) {
      sum += (surface.positions[c] - other.positions[c]) * other.normals[c];
    }
    return sum;
  });
}

/** Differences of the first body from the second one. */
export function differenceMap([surface, other]) {
  const values = differences(surface, other),
    range = rangeOf([values], [surface]);
  return { range, unit: 'mm', values: [scaled(values, range), new Float32Array(values.length)] };
}
