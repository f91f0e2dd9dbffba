// Bodies in the page of `bodyline browse`, in a browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openBrowser, openPage } from './browser.mjs';
import { choose, pictureOf, settled } from './page_actions.mjs';
import { blockNumbers } from './page_data.mjs';
import { makeFolder, makeStore, needBrowser, packages, run } from './support.mjs';

needBrowser();
const folder = makeFolder();
const table = makeStore(folder, 'space', 300);
run(folder, 'browse space.h5 -o space.html --bodies 12');
const html = readFileSync(join(folder, 'space.html'), 'utf8');
const browser = await openBrowser(packages);
after(() => browser.close());
const opened = () => openPage(browser.context, join(folder, 'space.html'));

test('the page opens without errors and asks the network for nothing', async () => {
  const { page, problems } = await opened();
  await settled(page);
  assert.deepEqual(problems, []);
  await page.close();
});

test('the 3-D view draws the chosen variant, and another one for another', async () => {
  const { page } = await opened();
  await settled(page);
  const rows = blockNumbers(html, 'body-rows', Int32Array);
  await choose(page, rows[0]);
  await settled(page);
  const first = await pictureOf(page);
  const drawn = await page.evaluate(() => {
    const canvas = document.querySelector('.stage canvas'),
      copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    return data.filter((_, k) => k % 4 === 3 && data[k] > 0).length / (copy.width * copy.height);
  });
  assert.ok(drawn > 0.1 && drawn < 0.9, `${drawn} of the picture is drawn`);
  await choose(page, rows.at(-1));
  await settled(page);
  assert.notEqual(await pictureOf(page), first);
  await page.close();
});

test('two variants are compared side by side and overlaid, by their difference', async () => {
  const { page } = await opened();
  const rows = blockNumbers(html, 'body-rows', Int32Array);
  await choose(page, rows[0]);
  await page.locator('.variant').getByRole('button', { name: 'Compare' }).click();
  await choose(page, rows.at(-1));
  const pictures = new Set();
  for (const name of ['Paint', 'Curvature', 'Difference']) {
    for (const layout of ['Apart', 'Overlaid']) {
      await page.getByRole('button', { name, exact: true }).click();
      await page.getByRole('button', { name: layout, exact: true }).click();
      await settled(page);
      pictures.add(await pictureOf(page));
    }
  }
  assert.equal(pictures.size, 6);
  assert.match(await page.textContent('.legend'), /mm/);
  await page.close();
});

test('the page says which variants have no body, and why', async () => {
  const { page } = await opened();
  const rows = new Set(blockNumbers(html, 'body-rows', Int32Array));
  const without = table.find((row, k) => row.status === 'valid' && !rows.has(k));
  await choose(page, Number(without.id));
  assert.match(await page.textContent('.message'), /holds the bodies of 12 of 300/);
  const broken = table.find((row) => row.status === 'fullness');
  await choose(page, Number(broken.id));
  assert.match(await page.textContent('.message'), /cannot be built: fullness \(roof__rear_window\)/);
  await page.close();
});
