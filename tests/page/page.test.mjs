// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of made-up runs: force = (1 + run/10) delta^1.5 loading, 3/4 of it unloading (sample_page.cpp).
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { launch, liveFigure, onPage, run, scratch, settled } from './browser.mjs';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const place = scratch();
const made = join(place, 'made.html'), report = join(place, 'report', 'index.html');
let browser;

before(async () => {
  run('MDANA_SAMPLE_PAGE', '3', made);
  run('MDANA', 'report', process.env.MDANA_SAMPLE, '-o', join(place, 'report'));
  browser = await launch();
});
after(() => browser.close());

/** Texts of the box with the values; the curve, x and y. */
async function values(figure) {
  const lines = await figure.locator('.values div').allTextContents();
  const number = (line) => Number(line.split(': ').at(-1).replace('−', '-'));
  return { curve: lines[0], x: number(lines[1]), y: number(lines[2]) };
}

async function pressed(figure, ...keys) {
  await figure.locator('.chart').focus();
  for (const key of keys) await figure.page().keyboard.press(key);
  await settled(figure.page());
}

const painted = (figure) => figure.locator('canvas').evaluate((c) => c.toDataURL());

test('a report: every figure has a picture and comes alive', () => onPage(browser, report, async (page) => {
  const figures = page.locator('figure[data-figure]');
  const count = await figures.count();
  assert.ok(count >= 8, `${count} figures`);
  for (const name of await figures.evaluateAll((all) => all.map((f) => f.dataset.figure))) {
    const figure = await liveFigure(page, name);
    assert.ok((await figure.locator('img').getAttribute('alt')).length > 20);
    assert.ok((await figure.locator('figcaption').textContent()).length > 20);
    assert.equal(await figure.locator('img').isVisible(), false);
  }
}));

test('without scripts the pictures and tables are there', () => onPage(browser, report, async (page) => {
  assert.equal(await page.locator('.live').count(), 0);
  for (const image of await page.locator('figure img').all()) {
    assert.ok(await image.isVisible());
    assert.ok(await image.evaluate((i) => i.complete && i.naturalWidth > 0));
  }
  assert.ok(await page.locator('table').count() >= 3);
}, { javaScriptEnabled: false }));

test('the pointer and the arrow keys show values', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'run-002-force');
  await pressed(figure, 'Escape', ...Array(5).fill('ArrowRight'));
  assert.deepEqual(await values(figure), { curve: 'run-002 · loading', x: 0.04, y: 0.0096 });
  await pressed(figure, 'ArrowDown');
  assert.deepEqual(await values(figure), { curve: 'run-002 · unloading', x: 1, y: 0.9 });

  // The pointer where the keys' ring was.
  for (const [steps, curve, y] of [[50, 'loading', 1.2 * 0.5 ** 1.5], [150, 'unloading', 0.9 * 0.51 ** 1.5]]) {
    await pressed(figure, 'Escape', ...Array(steps + 1).fill('ArrowRight'));
    const ring = await figure.locator('.ring').boundingBox();
    await pressed(figure, 'Escape');
    await figure.locator('.values').waitFor({ state: 'hidden' });
    await page.mouse.move(ring.x + ring.width / 2 + 1, ring.y + ring.height / 2);
    await figure.locator('.values').waitFor();
    const under = await values(figure);
    assert.equal(under.curve, `run-002 · ${curve}`);
    assert.equal(under.y, Number(y.toPrecision(6)));
  }
}));

test('a box, keys and buttons zoom', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'run-000-force');
  const first = async () => {
    await pressed(figure, 'Escape', 'ArrowRight');
    return (await values(figure)).x;
  };
  assert.equal(await first(), 0);
  const box = await figure.locator('.chart').boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.1 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 0.8 * box.height, { steps: 4 });
  await page.mouse.up();
  assert.ok(await first() > 0.4, 'the left half is out of the box');
  await figure.getByRole('button', { name: 'Reset the zoom' }).click();
  assert.equal(await first(), 0);
  await pressed(figure, '+');
  assert.ok(await first() > 0.2, 'a quarter of each side is cut off');
  await pressed(figure, '0');
  assert.equal(await first(), 0);
}));

test('log axes leave out what has no logarithm', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'run-000-force');
  const before = await painted(figure);
  await figure.getByRole('button', { name: 'log x' }).click();
  assert.equal(await figure.getByRole('button', { name: 'log x' }).getAttribute('aria-pressed'), 'true');
  assert.notEqual(await painted(figure), before);
  await pressed(figure, 'ArrowRight');
  assert.equal((await values(figure)).x, 0.01);
  await figure.getByRole('button', { name: 'log x' }).click();
  await pressed(figure, 'Escape', 'ArrowRight');
  assert.equal((await values(figure)).x, 0);
}));

test('runs are pointed at and hidden everywhere', () => onPage(browser, made, async (page) => {
  const loops = await liveFigure(page, 'loops'), speeds = await liveFigure(page, 'restitution');
  const row = page.locator('tr[data-run="run-001"]');
  const before = [await painted(loops), await painted(speeds)];
  await row.hover();
  await page.locator('tr[data-run="run-001"].pointed').waitFor();
  await settled(page);
  assert.notEqual(await painted(loops), before[0]);
  assert.notEqual(await painted(speeds), before[1]);
  await page.mouse.move(1, 1);
  await page.locator('tr[data-run="run-001"]:not(.pointed)').waitFor();
  await settled(page);
  assert.equal(await painted(loops), before[0]);

  await page.getByRole('checkbox', { name: 'run-001' }).uncheck();
  await settled(page);
  assert.equal(await row.evaluate((r) => r.classList.contains('off')), true);
  for (const figure of [loops, speeds])
    assert.equal(await figure.getByRole('button', { name: 'run-001' }).getAttribute('aria-pressed'), 'false');
  const seen = new Set();
  await pressed(loops, 'Escape', 'ArrowRight');
  for (let k = 0; k < 6; ++k) {
    seen.add((await values(loops)).curve.split(' ')[0]);
    await pressed(loops, 'ArrowUp');
  }
  assert.deepEqual([...seen].sort(), ['run-000', 'run-002']);
  await speeds.getByRole('button', { name: 'run-001' }).click();
  assert.equal(await page.getByRole('checkbox', { name: 'run-001' }).isChecked(), true);
}));

test('a curve is hidden by its legend, values come with errors', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'run-000-force');
  await figure.getByRole('button', { name: 'unloading' }).click();
  await pressed(figure, 'ArrowRight', 'ArrowUp', 'ArrowUp');
  assert.equal((await values(figure)).curve, 'run-000 · loading');
  const speeds = await liveFigure(page, 'restitution');
  await pressed(speeds, 'ArrowRight');
  assert.equal((await values(speeds)).curve, 'run-000 (made up)');
  assert.match((await speeds.locator('.values div').allTextContents())[2], /: 0\.666667 ± 0\.03$/);
  await speeds.getByRole('button', { name: 'Numbers' }).click();
  assert.equal(await speeds.locator('.numbers tbody tr').count(), 5);  // three runs, two of the law
  assert.deepEqual(await speeds.locator('.legend button').allTextContents(), ['law', 'run-000', 'run-001', 'run-002']);
}));

test('points tell their runs, and parts of a run have styles of their own', () => onPage(browser, made, async (page) => {
  const sizes = await liveFigure(page, 'sizes');
  await pressed(sizes, 'Escape', 'ArrowRight', 'ArrowRight');
  assert.deepEqual(await values(sizes), { curve: 'group 0 · run-002', x: 2, y: 4 });
  assert.equal(await page.locator('tr[data-run="run-002"].pointed').count(), 1);
  await sizes.getByRole('button', { name: 'Numbers' }).click();
  assert.deepEqual(await sizes.locator('.numbers tbody td:first-child').allTextContents(),
                   ['group 0 · run-000', 'group 0 · run-002', 'group 1 · run-001']);

  const energies = await liveFigure(page, 'energies');
  assert.deepEqual(await energies.locator('.legend button').allTextContents(), ['K_p', 'K_t', 'W', 'run-000', 'run-001', 'run-002']);
  const swatches = await energies.locator('.legend .swatch').evaluateAll((all) => all.slice(0, 3).map((s) => s.className));
  assert.deepEqual(swatches, ['swatch line', 'swatch dotted', 'swatch dash-dotted']);
  await pressed(energies, 'Escape', 'ArrowRight', 'ArrowDown');
  assert.equal((await values(energies)).curve, 'run-002 · W');
}));

test('tables are sorted by keys', () => onPage(browser, made, async (page) => {
  const column = page.getByRole('columnheader', { name: 'F_max' }).first();
  const names = () => page.locator('table').first().locator('tbody td:first-child').allTextContents();
  await column.getByRole('button').focus();
  await page.keyboard.press('Enter');
  assert.equal(await column.getAttribute('aria-sort'), 'ascending');
  assert.deepEqual(await names(), ['run-000', 'run-001', 'run-002']);
  await page.keyboard.press('Enter');
  assert.equal(await column.getAttribute('aria-sort'), 'descending');
  assert.deepEqual(await names(), ['run-002', 'run-001', 'run-000']);
}));

test('the 3-D view turns, changes frames and hides layers', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'defects');
  const seen = () => figure.locator('.stage').screenshot().then((bytes) => bytes.toString('base64'));
  const changed = async (change) => {
    const before = await seen();
    await change();
    await page.mouse.move(1, 1);
    await settled(page);
    assert.notEqual(await seen(), before);
  };
  assert.equal(await figure.locator('.legend button').count(), 8);  // six families, fault, atoms
  await changed(() => pressed(figure, 'ArrowRight'));
  await changed(() => figure.getByRole('button', { name: 'Shockley partials' }).click());
  await changed(() => figure.getByRole('button', { name: 'hcp atoms' }).click());
  await changed(() => figure.getByLabel('Frame').selectOption('1'));
  const shown = await liveFigure(page, 'runs/run-000/defects');  // begins with maximum compression
  assert.equal(await shown.locator('select').inputValue(), '1');
}));

test('without WebGL the still picture stays', async () => {
  const plain = await launch(['--disable-3d-apis']);
  const errors = [];
  const page = await plain.newPage();
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto(`file://${made}`);
  const figure = page.locator('figure[data-scene="defects"]');
  await figure.scrollIntoViewIfNeeded();
  await settled(page);
  assert.ok(await figure.locator('img').isVisible());
  assert.equal(await figure.locator('.live').count(), 0);
  await plain.close();
  assert.deepEqual(errors, []);
});

test('dark and light as the system says, or the button', () => onPage(browser, made, async (page) => {
  const back = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await back();
  await page.getByRole('button', { name: 'Light colours' }).click();
  assert.notEqual(await back(), dark);
  await page.getByRole('button', { name: 'Dark colours' }).click();
  assert.equal(await back(), dark);
}, { colorScheme: 'dark' }));

for (const colorScheme of ['light', 'dark'])
  for (const [what, file] of [['report', report], ['made-up page', made]])
    test(`axe finds nothing in the ${colorScheme} ${what}`, () => onPage(browser, file, async (page) => {
      await page.evaluate(readFileSync(axe, 'utf8'));
      for (const figure of await page.locator('figure').all()) await figure.scrollIntoViewIfNeeded();
      await settled(page);
      const { violations, passes } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map((v) => [v.id, v.nodes.map((n) => n.html.slice(0, 120))]), []);
      assert.ok(passes.length > 10);
    }, { colorScheme }));

test('print shows the pictures', () => onPage(browser, made, async (page) => {
  const figure = await liveFigure(page, 'loops');
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  assert.ok(await figure.locator('img').isVisible());
  assert.equal(await figure.locator('.live').isVisible(), false);
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
  assert.equal((await page.pdf()).subarray(0, 5).toString(), '%PDF-');
}));

test('the policy lets no other script run', async () => {
  const file = join(place, 'changed.html');
  const [head, tail] = readFileSync(made, 'utf8').split('</main>');
  writeFileSync(file, `${head}<script>document.title = 'run'</script></main>${tail}`);
  const page = await browser.newPage();
  await page.goto(`file://${file}`);
  assert.equal(await page.title(), 'Made-up runs');
  await page.close();
});

test('200 runs: less than 10 MB, painted within 2 s', async (t) => {
  const file = join(place, 'many.html');
  run('MDANA_SAMPLE_PAGE', '200', file);
  const bytes = readFileSync(file).length;
  let least = Infinity, live = Infinity;
  for (let k = 0; k < 3; ++k)  // the machine may be busy
    await onPage(browser, file, async (page) => {
      await page.locator('html[data-live]').waitFor();
      live = Math.min(live, await page.evaluate(() => performance.now()));
      least = Math.min(least, await page.evaluate(() =>
        performance.getEntriesByName('first-contentful-paint')[0].startTime));
    });
  const [size, paint, all] = [bytes / 1e6, least / 1e3, live / 1e3].map((v) => v.toFixed(2));
  t.diagnostic(`${size} MB, painted after ${paint} s, live after ${all} s`);
  assert.ok(bytes < 10e6);
  assert.ok(least < 2000);
});
