// Scenes of one or two bodies.
import { Vector3 } from 'three';
import { bodyMaterial, looks, scaleTexture } from '../../surface/material.js';
import { sceneOf } from '../../surface/stage.js';
import { geometryOf } from './geometry.js';
import { curvatureMap, differenceMap } from './maps.js';

const stripe = 7.5; // degrees of a zebra stripe
const paint = new Vector3(0.46, 0.55, 0.66),
  other = new Vector3(0.78, 0.55, 0.34);

export class Drawing {
  /** @param {import('./bodies.js').Bodies} bodies @param {Uint8Array} colours RGB of the map */
  constructor(bodies, colours) {
    this.bodies = bodies;
    this.texture = scaleTexture(colours);
    this.materials = [paint, other].map((tint) => this.material_(tint));
    this.old = [];
  }

  /**
   * @param {number[]} rows one or two
   * @param {{look: string, layout: string, cells: number}} style
   * @returns {{scenes: import('three').Scene[], map: {range: number, unit: string} | null}}
   */
  scenes(rows, { look, layout, cells }) {
    const { bodies } = this;
    this.old.forEach((thing) => thing.dispose());
    const surfaces = rows.map((row) => bodies.surface(row, cells));
    const map =
      look === 'curvature'
        ? curvatureMap(surfaces)
        : look === 'difference' && rows.length === 2
          ? differenceMap(surfaces)
          : null;
    const made = surfaces.map((surface, k) => {
      const values = map ? map.values[k] : new Float32Array(surface.curvatures.length);
      const geometry = geometryOf(surface, bodies.grid(cells), bodies.frame, values);
      const material = this.materials[k],
        { uniforms } = material;
      uniforms.look.value = map && !(look === 'difference' && k === 1) ? looks.map : (looks[look] ?? looks.paint);
      uniforms.opacity.value = 1;
      Object.assign(material, { transparent: false, depthWrite: true });
      return { ...geometry, material };
    });
    this.old = made;
    if (made.length < 2) return { scenes: [sceneOf(made)], map };
    if (layout === 'side') return { scenes: made.map((body) => sceneOf([body])), map };
    Object.assign(made[1].material, { transparent: true, depthWrite: false });
    made[1].material.uniforms.opacity.value = look === 'difference' ? 0.12 : 0.35;
    return { scenes: [sceneOf(made)], map };
  }

  // Materials are kept: the graphics card compiles one anew when the last that is like it is gone.
  material_(tint) {
    const material = bodyMaterial(this.texture, { period: stripe });
    material.uniforms.tint.value = tint;
    return material;
  }
}
