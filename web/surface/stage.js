// A canvas on which bodies stand, and the camera that goes around them.
import { Mesh, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';

const distance = 5,
  near = 3,
  far = 7;
const lift = 0.1; // of half the height: the body stands a little above the middle
const upright = new Vector3(0, 0, 1);

/** Where a camera looks from, in degrees: azimuth 0 from the front. */
export const home = { azimuth: 38, elevation: 16, zoom: 2.15 };

/** Points a perspective camera at the middle of a body of half size 1. */
function aim(camera, view, aspect) {
  const radians = Math.PI / 180,
    a = view.azimuth * radians,
    e = view.elevation * radians;
  camera.up = upright;
  camera.position.set(-Math.cos(a) * Math.cos(e), -Math.sin(a) * Math.cos(e), Math.sin(e));
  camera.position.multiplyScalar(distance);
  camera.lookAt(0, 0, 0);
  const focal = view.zoom * distance * Math.min(1, aspect / 2);
  camera.near = near;
  camera.far = far;
  camera.aspect = aspect;
  camera.fov = (2 * Math.atan(1 / focal)) / radians;
  camera.updateProjectionMatrix();
  camera.projectionMatrix.elements[9] -= lift;
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
}

export class Stage {
  /**
   * @param {HTMLCanvasElement} canvas
   * @throws when the browser has no WebGL
   */
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setClearColor(0, 0);
    this.renderer.autoClear = false;
    this.camera = new PerspectiveCamera();
  }

  /** Makes the drawing as large as the canvas is shown. */
  fit(width = this.canvas.clientWidth, height = this.canvas.clientHeight) {
    const density = Math.min(2, window.devicePixelRatio || 1);
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(Math.max(1, width), Math.max(1, height), false);
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  /** Whether so many bodies are larger one below the other than side by side. */
  isStacked(count) {
    const size = (width, height) => height * Math.min(1, width / height / 2);
    return size(this.width, this.height / count) > size(this.width / count, this.height);
  }

  /**
   * Draws scenes side by side or one below the other, all from the same point.
   * @param {Scene[]} scenes
   * @param {typeof home} view
   */
  draw(scenes, view) {
    const count = scenes.length,
      stacked = this.isStacked(count);
    const width = stacked ? this.width : this.width / count,
      height = stacked ? this.height / count : this.height;
    aim(this.camera, view, width / height);
    this.renderer.setScissorTest(true);
    scenes.forEach((scene, k) => {
      const place = stacked ? [0, (count - 1 - k) * height, width, height] : [k * width, 0, width, height];
      this.renderer.setViewport(...place);
      this.renderer.setScissor(...place);
      this.renderer.clear();
      this.renderer.render(scene, this.camera);
    });
  }
}

/**
 * A scene with both halves of bodies: each geometry and the part of it that is mirrored in y.
 * @param {{whole: import('three').BufferGeometry, mirrored: import('three').BufferGeometry,
 *   material: import('three').Material}[]} bodies
 */
export function sceneOf(bodies) {
  const scene = new Scene();
  bodies.forEach(({ whole, mirrored, material }) => {
    const left = new Mesh(whole, material),
      right = new Mesh(mirrored, material);
    right.scale.y = -1;
    left.frustumCulled = right.frustumCulled = false;
    scene.add(left, right);
  });
  return scene;
}
