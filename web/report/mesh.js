// The geometry of a report's bodies; io/report_mesh.hpp says how they are stored.
import { BufferAttribute, BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { gridTriangles } from '../surface/tessellate.js';

const perVertex = 8; // x, y, z, value, normal x, y, z, known

/** The bytes of a data block of the page. */
export function bytesOf(id) {
  const text = atob(document.getElementById(id).textContent);
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

function addAttributes(geometry, id, suffix) {
  const buffer = new InterleavedBuffer(new Int16Array(bytesOf(id).buffer), perVertex);
  const add = (name, size, offset) =>
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset, true));
  add(`position${suffix}`, 3, 0);
  add(`value${suffix}`, 1, 3);
  add(`normal${suffix}`, 3, 4);
  add(`known${suffix}`, 1, 7);
}

/**
 * Both bodies as one geometry with two sets of attributes, and the part of it that is mirrored.
 * @param {number} cells of every face in each direction
 * @param {boolean[]} mirrored of every face
 */
export function blendedGeometry(cells, mirrored) {
  const whole = new BufferGeometry();
  addAttributes(whole, 'mesh-before', '');
  addAttributes(whole, 'mesh-after', '1');
  const half = new BufferGeometry();
  Object.entries(whole.attributes).forEach(([name, attribute]) => half.setAttribute(name, attribute));
  const triangles = (takes) => new BufferAttribute(gridTriangles(mirrored, cells, takes), 1);
  whole.setIndex(triangles(() => true));
  half.setIndex(triangles((twice) => twice));
  return { whole, mirrored: half };
}
