// Geometries for the graphics card.
import { BufferAttribute, BufferGeometry } from 'three';

/** Positions in the common frame. */
function framed(positions, { centre, half }) {
  const placed = new Float32Array(positions.length);
  for (let k = 0; k < placed.length; ++k) placed[k] = (positions[k] - centre[k % 3]) / half;
  return placed;
}

/**
 * @param {ReturnType<import('./bodies.js').Bodies['surface']>} surface
 * @param {ReturnType<import('./bodies.js').Bodies['grid']>} grid
 * @param {{centre: number[], half: number}} frame
 * @param {Float32Array} values of the map, 1 where its colours end
 * @returns {{whole: BufferGeometry, mirrored: BufferGeometry, dispose: () => void}}
 */
export function geometryOf(surface, grid, frame, values) {
  const attributes = {
    position: new BufferAttribute(framed(surface.positions, frame), 3),
    normal: new BufferAttribute(surface.normals, 3),
    value: new BufferAttribute(values, 1),
    known: new BufferAttribute(new Float32Array(values.length).fill(1), 1),
  };
  const made = (triangles) => {
    const geometry = new BufferGeometry();
    Object.entries(attributes).forEach(([name, attribute]) => geometry.setAttribute(name, attribute));
    return geometry.setIndex(new BufferAttribute(triangles, 1));
  };
  const whole = made(grid.whole),
    mirrored = made(grid.mirrored);
  return { whole, mirrored, dispose: () => [whole, mirrored].forEach((geometry) => geometry.dispose()) };
}
