// firefox.cjs NODE_MODULES FIREFOX PAGE [SIMPLIFIER MESH]: opens a page of a recording in Firefox, looks at each way to show
// it, and plays it; then has the page that simplifies make a mesh smaller.
'use strict';
const assert = require('assert/strict');
const path = require('path');
const [nodeModules, firefox, file, simplifier, mesh] = process.argv.slice(2);
const puppeteer = require(path.join(path.resolve(nodeModules), 'puppeteer-core'));

/** A sum that tells pictures apart, when all is drawn. */
const picture = (page) => page.evaluate(async () => {
  await window.whittle.drawn();
  const gl = document.getElementById('canvas').getContext('webgl2');
  const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels.reduce((sum, byte) => Math.imul(sum, 31) + byte | 0, 0);
});

async function usesThePage(page) {
  await page.waitForFunction(() => document.documentElement.dataset.ready);
  const seen = new Set([await picture(page)]);
  for (const layout of ['split', 'over', 'original', 'result']) {
    await page.select('#layout', layout);
    seen.add(await picture(page));
  }
  await page.select('#colour', 'error');
  seen.add(await picture(page));
  await page.click('#edges');
  seen.add(await picture(page));
  assert.equal(seen.size, 7, 'each choice looks different');
  await page.evaluate(() => window.whittle.playing.stopAt(0.2));
  await page.click('#play');
  await page.waitForFunction(() => window.whittle.player.place > 0.25);
  await page.click('#play');
  const stopped = await page.$eval('#level', (element) => element.textContent);
  assert.match(stopped, /^[\d,]+ faces, [\d,]+ contractions$/);
}

async function simplifies(page) {
  const files = await page.$('#files');
  await files.uploadFile(path.resolve(mesh));
  await page.waitForFunction(() => window.whittle?.recording);
  const original = await picture(page);
  await page.click('#simplify');
  await page.waitForFunction(() => document.querySelectorAll('#made dt').length > 3);
  assert.match(await page.$eval('#made', (element) => element.textContent), /^Faces[\d,]+, 10 %Mean/);
  assert.notEqual(await picture(page), original);
  assert.equal(await page.$eval('#alert', (element) => element.textContent), '');
}

async function main() {
  const browser = await puppeteer.launch({browser: 'firefox', executablePath: firefox, headless: false,
    extraPrefsFirefox: {'webgl.force-enabled': true}}); // also where software draws
  const page = await browser.newPage();
  const messages = [];
  page.on('console', (message) => messages.push(message.text()));
  page.on('pageerror', (error) => messages.push(error.message));
  await page.setViewport({width: 900, height: 700});
  await page.goto(`file://${path.resolve(file)}`);
  await usesThePage(page);
  if (simplifier) {
    await page.goto(`file://${path.resolve(simplifier)}`);
    await simplifies(page);
  }
  assert.deepEqual(messages, [], 'the page is silent');
  await browser.close();
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
