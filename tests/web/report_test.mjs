// The view in three dimensions of a report, in a browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openBrowser } from './browser.mjs';
import { makeFolder, needBrowser, packages, reportPage } from './support.mjs';

needBrowser();
const folder = makeFolder();
writeFileSync(join(folder, 'report.html'), execFileSync(reportPage, { maxBuffer: 1 << 28 }));
const browser = await openBrowser(packages);
after(() => browser.close());

const problems = [];
const page = await browser.context.newPage();
page.on('request', (request) => /^(file|data|blob):/.test(request.url()) || problems.push(request.url()));
page.on('pageerror', (error) => problems.push(error.message));
page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
await page.goto(`file://${join(folder, 'report.html')}`);
await page.locator('#viewer canvas').scrollIntoViewIfNeeded();

/** The drawing, once it is made, and how much of it is covered. */
const drawing = () =>
  page.evaluate(
    () =>
      new Promise((done) => {
        requestAnimationFrame(() =>
          requestAnimationFrame(() => {
            const canvas = document.querySelector('#viewer canvas'),
              copy = document.createElement('canvas');
            [copy.width, copy.height] = [canvas.width, canvas.height];
            const context = copy.getContext('2d');
            context.drawImage(canvas, 0, 0);
            const { data } = context.getImageData(0, 0, copy.width, copy.height);
            done({
              url: copy.toDataURL(),
              covered: data.filter((_, k) => k % 4 === 3 && data[k] > 0).length / (copy.width * copy.height),
            });
          }),
        );
      }),
  );

test('the report draws the body', async () => {
  const { covered } = await drawing();
  assert.ok(covered > 0.1 && covered < 0.9, `${covered} of the picture is drawn`);
  assert.deepEqual(problems, []);
});

test('every look, blend and direction is another picture', async () => {
  const pictures = new Set([(await drawing()).url]);
  for (const name of ['Zebra', 'Mean curvature']) {
    await page.locator('#viewer').getByRole('button', { name }).click();
    pictures.add((await drawing()).url);
  }
  await page.fill('#viewer .blend', '0');
  pictures.add((await drawing()).url);
  await page.focus('#viewer canvas');
  await page.keyboard.press('ArrowLeft');
  pictures.add((await drawing()).url);
  assert.equal(pictures.size, 5);
});
