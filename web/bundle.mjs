// Bundles the pages: node bundle.mjs PACKAGES OUTPUT. PACKAGES is a folder in which `npm ci` was run.
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [packages, output] = process.argv.slice(2).map((path) => resolve(path));
const sources = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(packages, 'package.json'))('esbuild');

const common = {
  bundle: true,
  minify: true,
  target: ['chrome100', 'firefox100', 'safari15.4'],
  charset: 'ascii',
  legalComments: 'inline',
  nodePaths: [join(packages, 'node_modules')],
  logLevel: 'warning',
};

/**
 * @param {string} entry source file
 * @param {string} name of the bundle
 */
function bundle(entry, name) {
  return esbuild.build({
    ...common,
    format: 'iife',
    entryPoints: [join(sources, entry)],
    outfile: join(output, name),
  });
}

try {
  await Promise.all([
    bundle('browse/main.js', 'browse.js'),
    bundle('browse/page.css', 'browse.css'),
    bundle('report/viewer.js', 'report_viewer.js'),
  ]);
} catch {
  process.exitCode = 1; // esbuild has said why
}
