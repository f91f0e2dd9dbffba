// What the tests of the pages share.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromiumPath } from './browser.mjs';

export const [packages, bodyline, facePoints, reportPage] = process.argv.slice(2).map((path) => resolve(path));
const cars = resolve(dirname(fileURLToPath(import.meta.url)), '../../cars');

/** Ends the test as skipped, and says so, where there is no browser. */
export function needBrowser() {
  if (existsSync(chromiumPath)) return;
  console.log(`SKIPPED: there is no ${chromiumPath}; install the Debian package chromium.`);
  process.exit(77);
}

/** A folder that is gone when the process ends. */
export function makeFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'bodyline-web-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Runs the program with words between spaces in a folder and returns what it prints. */
export const run = (folder, words) =>
  execFileSync(bodyline, words.split(' '), { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** A store of so many variants of model 1, SPACE.h5, and all its rows by `space table`. */
export function makeStore(folder, name, count, rest = '') {
  writeFileSync(
    join(folder, `${name}.toml`),
    `format = 1
name = "${name}"
model = "${cars}/model1.toml"
[variables]
fullness = { vary = ["fullness.hood*"], range = [1.0, 2.0] }
roof = { vary = ["curve.roof__side_window[1-4].z"], offset = [-20, 20] }
lean = { vary = ["fullness.roof__rear_window.a"], range = [2.0, 3.5] }
[metrics]
bending = {}
height = {}
length = {}
[constraints]
height = { most = 1215.0 }
[checks]
folds = false
${rest}
[sampler]
kind = "sobol"
count = ${count}
`,
  );
  run(folder, `explore ${name}.toml -o ${name}.h5`);
  run(folder, `space ${name}.h5 table -o ${name}.csv`);
  return readTable(readFileSync(join(folder, `${name}.csv`), 'utf8'));
}

/** A CSV file as an array of objects; numbers stay text. */
export function readTable(text) {
  const [head, ...lines] = text
    .trimEnd()
    .split('\n')
    .map((line) => line.split(','));
  return lines.map((line) => Object.fromEntries(head.map((name, k) => [name, line[k]])));
}

/** The number in a field of such a table; NaN where it is empty. */
export const numberOf = (text) => (text === '' ? NaN : Number(text));
