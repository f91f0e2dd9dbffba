// Measures how long frames take while a range is dragged: node measure_brushing.mjs PACKAGES PAGE.html
import { resolve } from 'node:path';
import { openBrowser, openPage } from './browser.mjs';

const [packages, path] = process.argv.slice(2).map((name) => resolve(name));
const moves = 120;

/** Median, 95th percentile and maximum of some times. */
function summary(times) {
  const sorted = [...times].sort((a, b) => a - b),
    at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(1);
  return `median ${at(0.5)}, 95 % ${at(0.95)}, most ${at(1)} ms (${times.length} frames)`;
}

const browser = await openBrowser(packages);
const began = performance.now();
const { page } = await openPage(browser.context, path);
console.log(`opened in ${Math.round(performance.now() - began)} ms`);
await page.waitForTimeout(3000); // thumbnails
await page.evaluate(() => {
  window.measured = { scripts: [], frames: [] };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (draw) =>
    request((time) => {
      const start = performance.now();
      draw(time);
      window.measured.scripts.push(performance.now() - start);
    });
  let last = 0;
  const tick = (time) => {
    if (last) window.measured.frames.push(time - last);
    last = time;
    request(tick);
  };
  request(tick);
});
const strips = await page.$$('.strip');
const box = await strips[strips.length - 3].boundingBox(),
  x = box.x + box.width / 2;
await page.mouse.move(x, box.y + 20);
await page.mouse.down();
for (let k = 1; k <= moves; ++k) {
  await page.mouse.move(x, box.y + 20 + (box.height - 40) * (0.5 - 0.5 * Math.cos((3 * Math.PI * k) / moves)));
}
await page.mouse.up();
const { scripts, frames } = await page.evaluate(() => window.measured);
console.log(`scripts of a frame: ${summary(scripts)}`);
console.log(`from frame to frame: ${summary(frames)}`);
console.log(await page.textContent('.count'));
await browser.close();
