// The page evaluates bodies as the library does.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { placeFaces } from '../../web/surface/bezier.js';
import { gridTables, tessellate } from '../../web/surface/tessellate.js';
import { blockNumbers, description } from './page_data.mjs';
import { facePoints, makeFolder, makeStore, run } from './support.mjs';

const cells = 7;
// The page's nets are 32-bit numbers, which are up to 2.5e-4 mm off at a car's length.
const pointTolerance = 1e-3; // mm
// Normals and curvatures are those of nets with all their digits; they are kept as 32-bit numbers. At
// corners where derivatives vanish, rounding counts for more.
const normalTolerance = 1e-5;
const curvatureTolerance = 1e-5; // relative, and 1/m

const folder = makeFolder();
makeStore(folder, 'nets', 4, '[keep]\nnets = true');
run(folder, 'browse nets.h5 -o nets.html');
const html = readFileSync(join(folder, 'nets.html'), 'utf8');
const about = description(html),
  faces = placeFaces(about.faces);
const points = blockNumbers(html, 'body-points', Float32Array);
const place = 1,
  row = blockNumbers(html, 'body-rows', Int32Array)[place];
const size = 3 * about.bodyPoints;
const surface = tessellate(faces, points.subarray(place * size, (place + 1) * size), gridTables(faces, cells));
run(folder, `space nets.h5 model ${row} -o car.toml`);
const expected = JSON.parse(
  execFileSync(facePoints, [join(folder, 'car.toml'), String(cells)], { maxBuffer: 1 << 28 }),
);
const vertices = (cells + 1) ** 2;
const exact = tessellate(faces, Float64Array.from(expected.flatMap(({ net }) => net.flat())), gridTables(faces, cells));

// Calls `use` with the place of every vertex, its face and its place there.
function eachVertex(use) {
  expected.forEach((face, f) => {
    for (let k = 0; k < vertices; ++k) use(f * vertices + k, face, k);
  });
}

const distance = (array, at, other) => Math.hypot(...other.map((value, c) => value - array[3 * at + c]));

test('the faces are those of the library, in its order', () => {
  assert.deepEqual(
    faces.map(({ name }) => name),
    expected.map(({ name }) => name),
  );
  assert.ok(
    faces.some(({ blend }) => blend),
    'a face with a Gregory term is among them',
  );
});

test('points are those of the library', () => {
  eachVertex((at, face, k) => {
    const away = distance(surface.positions, at, face.points[k]);
    assert.ok(away <= pointTolerance, `${face.name} vertex ${k}: ${away} mm`);
  });
});

test('normals are those of the library', () => {
  eachVertex((at, face, k) => {
    const away = distance(exact.normals, at, face.normals[k]);
    assert.ok(away <= normalTolerance, `${face.name} vertex ${k}: ${away}`);
  });
});

test('mean curvatures are those of the library', () => {
  eachVertex((at, face, k) => {
    const wanted = face.curvatures[k],
      away = Math.abs(exact.curvatures[at] - wanted);
    assert.ok(
      away <= curvatureTolerance * (1 + Math.abs(wanted)),
      `${face.name} vertex ${k}: ${exact.curvatures[at]} instead of ${wanted}`,
    );
  });
});
