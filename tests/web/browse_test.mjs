// Numbers, selections and texts of the page of `bodyline browse`, in a browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openBrowser, openPage } from './browser.mjs';
import { choose, exported, selectedText, setRange, settled } from './page_actions.mjs';
import { blockNumbers, blockText, description } from './page_data.mjs';
import { bodyline, makeFolder, makeStore, needBrowser, numberOf, packages, readTable, run } from './support.mjs';

needBrowser();
const folder = makeFolder();
const table = makeStore(folder, 'space', 300);
// Without bodies, which take the browser longest.
run(folder, 'browse space.h5 -o space.html --minimize bending --maximize length --bodies 0');
run(folder, 'browse space.h5 -o sample.html --limit 60 --bodies 0');
const html = readFileSync(join(folder, 'space.html'), 'utf8');
const about = description(html);
const browser = await openBrowser(packages);
after(() => browser.close());

const columnNames = about.columns.map(({ name, metric }) => `${metric ? 'out' : 'in'}:${name}`);
const ids = (rows) => rows.map(({ id }) => Number(id));
const opened = (name = 'space.html') => openPage(browser.context, join(folder, name));

test('every number in the page has all bits of that in the store', () => {
  columnNames.forEach((name, k) => {
    const values = blockNumbers(html, `column-${k}`, Float64Array);
    assert.equal(values.length, table.length);
    table.forEach((row, at) => assert.ok(Object.is(values[at], numberOf(row[name])), `${name} of ${row.id}`));
  });
  const causes = blockNumbers(html, 'cause', Uint16Array),
    statuses = blockNumbers(html, 'status', Uint8Array);
  table.forEach((row, at) => {
    assert.equal(about.statuses[statuses[at]], row.status);
    assert.equal(about.causes[causes[at]], row.cause);
  });
});

test('thumbnails are those of the store', () => {
  const kept = makeStore(folder, 'pictures', 5, '[keep]\nthumbnails = 96');
  run(folder, 'browse pictures.h5 -o pictures.html --bodies 0');
  const pictures = JSON.parse(blockText(readFileSync(join(folder, 'pictures.html'), 'utf8'), 'pictures'));
  const built = kept.filter(({ img }, row) => {
    const file = readFileSync(join(folder, img));
    return pictures[row] !== undefined && file.equals(Buffer.from(pictures[row], 'base64'));
  });
  assert.equal(built.length, kept.filter(({ status }) => status !== 'fullness').length);
  assert.ok(built.length > 1);
});

test('a chosen variant shows its numbers with all their digits', async () => {
  const { page } = await opened();
  for (const id of [0, 7, 299]) {
    await choose(page, id);
    const shown = await page.$$eval('.numbers tr', (lines) =>
      lines.map((line) => [Number(line.dataset.column), line.querySelector('.value').textContent]),
    );
    assert.equal(shown.length, columnNames.length);
    shown.forEach(([column, text]) => {
      const wanted = numberOf(table[id][columnNames[column]]);
      assert.ok(
        Number.isNaN(wanted) ? text === '–' : Object.is(Number(text), wanted),
        `${columnNames[column]} of ${id}: ${text}`,
      );
    });
  }
  await page.close();
});

test('numbers in the table have all digits when pointed at', async () => {
  const { page } = await opened();
  const rows = await page.$$eval('.tbody .tr', (lines) =>
    lines.map((line) => [line.dataset.id, [...line.children].slice(2, 5).map((cell) => cell.title)]),
  );
  assert.ok(rows.length > 5);
  rows.forEach(([id, titles]) =>
    titles.forEach((title, k) => {
      const wanted = numberOf(table[id][`out:${['bending', 'height', 'length'][k]}`]);
      assert.ok(Number.isNaN(wanted) ? title === '–' : Object.is(Number(title), wanted));
    }),
  );
  await page.close();
});

test('ranges on several axes select exactly the rows within them', async () => {
  const { page } = await opened();
  const [low, high, most] = [table[10], table[20], table[30]]
    .map((row) => Number(row['out:bending']))
    .sort((a, b) => a - b);
  await setRange(page, 'bending', String(low), String(most));
  await setRange(page, 'height', '1205', '1215');
  const wanted = table.filter(
    (row) =>
      numberOf(row['out:bending']) >= low &&
      numberOf(row['out:bending']) <= most &&
      numberOf(row['out:height']) >= 1205 &&
      numberOf(row['out:height']) <= 1215,
  );
  assert.ok(high > low && wanted.length > 5 && wanted.length < 200);
  assert.equal(await selectedText(page), `${wanted.length} of 300 selected`);
  assert.deepEqual(ids(await exported(page)), ids(wanted));
  await page.getByRole('button', { name: 'Clear' }).first().click();
  assert.equal(await selectedText(page), '300 of 300 selected');
  await page.close();
});

test('dragging along an axis selects the rows of that part of it', async () => {
  const { page } = await opened();
  const column = columnNames.indexOf('out:height');
  const box = await page.locator(`.strip[data-column="${column}"]`).boundingBox();
  const x = box.x + box.width / 2,
    at = (up) => box.y + (1 - up) * box.height;
  await page.mouse.move(x, at(0.25));
  await page.mouse.down();
  await page.mouse.move(x, at(0.6), { steps: 5 });
  await page.mouse.move(x, at(0.75));
  await page.mouse.up();
  const values = table.map((row) => numberOf(row['out:height'])).filter(Number.isFinite);
  const least = Math.min(...values),
    range = Math.max(...values) - least;
  const pixel = range / box.height;
  const selected = (await exported(page)).map((row) => Number(row['out:height']));
  const inside = (margin) => values.filter((value) => Math.abs(value - least - range / 2) <= range / 4 + margin).length;
  assert.ok(selected.length >= inside(-2 * pixel) && selected.length <= inside(2 * pixel) && selected.length > 20);
  await page.close();
});

test('an export holds the selected rows as `space table` writes them', async () => {
  const { page } = await opened();
  await page.getByRole('button', { name: /^infeasible/ }).click();
  const rows = await exported(page),
    wanted = table.filter((row) => row.status !== 'infeasible');
  assert.deepEqual(ids(rows), ids(wanted));
  rows.forEach((row, k) =>
    Object.entries(wanted[k]).forEach(([name, text]) => {
      if (name === 'status' || name === 'cause') assert.equal(row[name], text);
      else assert.ok(Object.is(numberOf(row[name]), numberOf(text)), `${name} of ${row.id}`);
    }),
  );
  await page.close();
});

test('the Pareto set is that of the program, for given and for changed objectives', async () => {
  const { page } = await opened();
  const front = (...words) =>
    JSON.parse(
      execFileSync(bodyline, ['space', 'space.h5', 'pareto', '--json', ...words], { cwd: folder }),
    ).variants.map(({ id }) => id);
  await page.getByLabel('Pareto set only').check();
  assert.deepEqual(ids(await exported(page)), front('--minimize', 'bending', '--maximize', 'length'));
  await page.click('.objectives button[aria-label^="length should be large"]');
  assert.deepEqual(ids(await exported(page)), front('--minimize', 'bending,length'));
  await page.selectOption('.objectives select', { label: 'height' });
  assert.deepEqual(ids(await exported(page)), front('--minimize', 'bending,length,height'));
  await page.close();
});

test('the table sorts by a column, both ways', async () => {
  const { page } = await opened();
  const first = async () => {
    await settled(page);
    return page.$eval('.tbody .tr', (line) => line.dataset.id);
  };
  const measured = table
    .filter((row) => row['out:bending'] !== '')
    .sort((a, b) => Number(a['out:bending']) - Number(b['out:bending']));
  await page.getByRole('columnheader', { name: 'bending' }).click();
  assert.equal(await first(), measured[0].id);
  await page.getByRole('columnheader', { name: 'bending' }).click();
  assert.equal(await first(), measured.at(-1).id);
  await page.close();
});

test('the nearest variants are the nearest', async () => {
  const { page } = await opened();
  await choose(page, 5);
  const names = columnNames.filter((name) => name.startsWith('in:'));
  const ranges = names.map((name) => {
    const values = table.map((row) => Number(row[name]));
    return Math.max(...values) - Math.min(...values);
  });
  const away = (row) => Math.hypot(...names.map((name, k) => (Number(row[name]) - Number(table[5][name])) / ranges[k]));
  const wanted = ids(
    table
      .filter(({ id }) => id !== '5')
      .sort((a, b) => away(a) - away(b))
      .slice(0, 8),
  );
  assert.deepEqual(
    await page.$$eval('.neighbours button', (buttons) => buttons.map((button) => Number(button.dataset.id))),
    wanted,
  );
  await page.close();
});

test('the texts of a variant make the same model in two ways', async () => {
  const { page } = await opened();
  await choose(page, 12);
  await page.getByRole('button', { name: 'Copy …' }).click();
  const text = (kind) => page.$eval(`.entry[data-kind="${kind}"] textarea`, (area) => area.value);
  const commands = [await text('model'), (await text('set')).replace('space-12.toml', 'set.toml')];
  commands.forEach((command) =>
    execFileSync('bash', ['-e', '-c', command.replace('bodyline', `'${bodyline}'`)], { cwd: folder }),
  );
  // Name and notes differ.
  const numbers = (name) =>
    readFileSync(join(folder, name), 'utf8')
      .replace(/^[^]*?(?=\[curves)/, '')
      .replace(/^note = .*\n/gm, '');
  assert.equal(numbers('set.toml'), numbers('space-12.toml'));
  assert.deepEqual(readTable(await text('list'))[0].id, '12');
  await page.close();
});

test('a column can be found, shown and hidden, moved and set on a logarithmic scale', async () => {
  const { page } = await opened();
  const shown = () => page.$$eval('.heading', (headings) => headings.map((heading) => heading.firstChild.textContent));
  const before = await shown();
  await page.getByRole('button', { name: 'Columns …' }).click();
  await page.fill('dialog.picker input[type="search"]', 'roof window[2]');
  const boxes = page.locator('.picker .list input');
  assert.equal(await boxes.count(), 1);
  await boxes.first().setChecked(!before.includes('curve.roof__side_window[2].z'));
  await page.getByRole('button', { name: 'Done' }).click();
  const changed = await shown();
  assert.equal(Math.abs(changed.length - before.length), 1);
  await page.locator('.heading').first().click();
  await page.getByRole('button', { name: 'Move →' }).click();
  await page.getByLabel('Logarithmic').check();
  await page.keyboard.press('Escape');
  assert.deepEqual((await shown()).slice(0, 2), [changed[1], changed[0]]);
  await page.close();
});

test('a heading that is dragged moves its axis', async () => {
  const { page } = await opened();
  const shown = () => page.$$eval('.heading', (headings) => headings.map((heading) => heading.dataset.column));
  const before = await shown();
  const [from, to] = [
    await page.locator('.heading').nth(0).boundingBox(),
    await page.locator('.heading').nth(2).boundingBox(),
  ];
  await page.mouse.move(from.x + from.width / 2, from.y + 40);
  await page.mouse.down();
  await page.mouse.move(to.x + to.width / 2, to.y + 40, { steps: 5 });
  await page.mouse.up();
  assert.deepEqual((await shown()).slice(0, 3), [before[1], before[2], before[0]]);
  await page.close();
});

test('a sample says that it is one', async () => {
  const { page } = await opened('sample.html');
  assert.match(
    await page.textContent('.limits'),
    /holds 300 variants; the page shows 60, evenly sampled, with the whole Pareto set of small bending and small height\./,
  );
  await page.close();
});
