// The body of a report in three dimensions: both versions, blended.
import { bodyMaterial, scaleTexture } from '../surface/material.js';
import { home, sceneOf, Stage } from '../surface/stage.js';
import { turntable } from '../surface/turntable.js';
import { blendedGeometry, bytesOf } from './mesh.js';

/** @param {HTMLElement} section written by io/report_viewer.cpp */
function viewer(section) {
  const canvas = section.querySelector('canvas');
  let stage;
  try {
    stage = new Stage(canvas);
  } catch {
    return; // without WebGL the section stays hidden
  }
  section.hidden = false;
  const { cells, mirrored, stripe, look } = section.dataset;
  const material = bodyMaterial(scaleTexture(bytesOf('map-colors')), { period: Number(stripe), blended: true });
  const geometry = blendedGeometry(
    Number(cells),
    [...mirrored].map((flag) => flag === '1'),
  );
  const scenes = [sceneOf([{ ...geometry, material }])];
  const view = { ...home };
  let waiting = false;
  const redraw = () => {
    if (!waiting) {
      requestAnimationFrame(() => {
        waiting = false;
        stage.draw(scenes, view);
      });
    }
    waiting = true;
  };
  turntable(canvas, view, redraw);
  const blend = section.querySelector('.blend');
  blend?.addEventListener('input', () => {
    material.uniforms.blend.value = Number(blend.value);
    redraw();
  });
  window.reportTabs(
    [...section.querySelectorAll('.tabs button')],
    (index) => {
      material.uniforms.look.value = index;
      section.querySelector('.scale').hidden = index !== 2;
      redraw();
    },
    Number(look),
  );
  new ResizeObserver(() => {
    stage.fit();
    redraw();
  }).observe(canvas);
}

const section = document.getElementById('viewer');
if (section) viewer(section);
