// Makes the pictures of docs/browsing.md: node screenshots.mjs PACKAGES PAGE.html DOCS, where the page is
// that of the store of examples/family.toml, with --minimize bending --maximize volume --limit 120: fewer lines make smaller files.
import { join, resolve } from 'node:path';
import { openBrowser, openPage } from './browser.mjs';

const [packages, path, docs] = process.argv.slice(2).map((name) => resolve(name));
const browser = await openBrowser(packages, { width: 1200, height: 790 });
const { page } = await openPage(browser.context, path);

const strip = await page.locator('.strip').nth(4).boundingBox(),
  x = strip.x + strip.width / 2;
await page.mouse.move(x, strip.y + strip.height - 2);
await page.mouse.down();
await page.mouse.move(x, strip.y + strip.height - 24, { steps: 4 });
await page.mouse.up();
await page.mouse.move(0, 0);
await page.waitForTimeout(3000);
const end = await page.locator('.axes').boundingBox();
await page.screenshot({
  path: join(docs, 'browse.png'),
  clip: { x: 0, y: 0, width: 1200, height: end.y + end.height + 8 },
});

await page.getByRole('button', { name: 'Clear' }).first().click();
await page.locator('.variant').getByRole('button', { name: 'Compare' }).click();
await page.locator('.tile').nth(60).click();
await page.getByRole('button', { name: 'Difference' }).click();
await page.mouse.move(0, 0);
await page.waitForTimeout(1500);
await page.locator('.middle').screenshot({ path: join(docs, 'browse-difference.png') });
await browser.close();
