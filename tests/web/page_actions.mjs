// What a user does with the page of `browse`, and what they see.
import { readFileSync } from 'node:fs';
import { readTable } from './support.mjs';

/** Numbers of selected variants, as the page exports them. */
export async function exported(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('.export')]);
  return readTable(readFileSync(await download.path(), 'utf8'));
}

/** Chooses a variant in the table. */
export async function choose(page, id) {
  await page.evaluate((wanted) => {
    document.querySelector('.table').scrollTop = 28 * wanted;
  }, id);
  await page.click(`.tr[data-id="${id}"]`);
}

/** Gives an axis a range through its menu. */
export async function setRange(page, name, least, most) {
  await page.click(`.heading[title^="${name}:"]`);
  await page.fill('dialog.menu input[aria-label="least"]', least);
  await page.fill('dialog.menu input[aria-label="most"]', most);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Escape');
}

export const selectedText = (page) => page.textContent('.count');
export const pictureOf = (page) => page.evaluate(() => document.querySelector('.stage canvas').toDataURL());
/** Once the page has drawn what it was asked for. */
export const settled = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        let frames = 5;
        const next = () => (--frames ? requestAnimationFrame(next) : done());
        requestAnimationFrame(next);
      }),
  );
