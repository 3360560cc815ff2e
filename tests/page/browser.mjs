// SPDX-License-Identifier: GPL-3.0-or-later
// A page in Debian's chromium, and what must hold of every page: no errors, nothing asked of anyone.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { chromium } from 'playwright-core';

const quiet = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const webgl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export const launch = (flags = webgl) =>
  chromium.launch({ executablePath: process.env.MDANA_CHROMIUM, args: [...quiet, ...flags] });

/** A directory that is removed at the end. */
export function scratch() {
  const place = mkdtempSync(join(tmpdir(), 'mdana-page-'));
  process.on('exit', () => rmSync(place, { recursive: true, force: true }));
  return place;
}

export const run = (program, ...words) => execFileSync(process.env[program], words, { stdio: 'pipe' });

/** Runs `test` on the page; afterwards the page must have kept quiet. */
export async function onPage(browser, file, test, settings = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 1000 }, ...settings });
  const page = await context.newPage();
  const errors = [], requests = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('request', (request) => requests.push(request.url()));
  const url = pathToFileURL(file).href;
  await page.goto(url);
  await test(page);
  await context.close();
  assert.deepEqual(errors, []);
  assert.deepEqual(requests.filter((r) => !r.startsWith('data:')), [url]);
}

/** The figure of a name, near the window and live. */
export async function liveFigure(page, name) {
  const figure = page.locator(`figure[data-figure="${name}"], figure[data-scene="${name}"]`);
  await figure.scrollIntoViewIfNeeded();
  await settled(page);
  await figure.scrollIntoViewIfNeeded();  // figures above may have grown as they came alive
  await figure.locator('.chart').waitFor();
  await settled(page);
  return figure;
}

/** After the next two frames are painted. */
export const settled = (page) => page.evaluate(() =>
  new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
