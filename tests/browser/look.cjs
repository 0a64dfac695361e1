// look.cjs NODE_MODULES CHROMIUM FOLDER: opens the pages that run.sh has written and tries them. Fails if one of the
// checks fails, or if a page prints to the console or asks for anything but itself.
'use strict';
const assert = require('assert/strict');
const fs = require('fs');
const path = require('path');
const {pixelsOfCanvas} = require('./canvas.cjs');
const {stepsOff} = require('./colours.cjs');
const {openBrowser} = require('./pages.cjs');
const textured = require('./textured.cjs');

const [nodeModules, chromium, folder] = process.argv.slice(2);
const file = (name) => path.resolve(folder, name);
const readJson = (name) => JSON.parse(fs.readFileSync(file(name), 'utf8'));

const desktop = {width: 1200, height: 900}; // of pages that are to be seen in a large window

let withPage;

/** Waits until what was asked for is drawn. */
const drawn = (page) => page.evaluate(() => window.whittle.drawn());

/** The pixels of the canvas: of each half, how many differ from the background, and a sum that tells pictures apart. */
async function pixels(page) {
  await drawn(page);
  return page.evaluate(({data, width, height}) => {
    const halves = [{shown: 0, sum: 0}, {shown: 0, sum: 0}];
    const colours = new Int32Array(data.buffer);
    for (let y = 0, i = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, ++i) {
        const half = halves[x < width / 2 ? 0 : 1];
        if (colours[i] !== colours[0]) ++half.shown;
        half.sum = Math.imul(half.sum, 31) + colours[i] | 0;
      }
    }
    return {halves, background: [data[0], data[1], data[2]], nPixels: width * height};
  }, await pixelsOfCanvas(page));
}

const text = (page, id) => page.$eval(`#${id}`, (element) => element.textContent);
const nFacesOf = (label) => Number(/([\d,]+) faces?/.exec(label)[1].replaceAll(',', ''));

async function showsBothMeshes(page) {
  const {halves, nPixels} = await pixels(page);
  for (const {shown} of halves) assert.ok(shown > nPixels / 200, 'a half of the picture is empty');
  assert.notEqual(halves[0].sum, halves[1].sum, 'both halves are the same');
}

async function showsEachLevel(page, levels) {
  const n = levels.length - 1;
  const counts = await page.evaluate((last) => {
    const slider = document.getElementById('slider');
    const shown = [];
    for (let i = 0; i <= last; ++i) {
      slider.value = 1000 * i / last;
      slider.dispatchEvent(new Event('input'));
      shown.push(document.getElementById('level').textContent);
    }
    for (let i = last; i >= 0; --i) { // and back
      slider.value = 1000 * i / last;
      slider.dispatchEvent(new Event('input'));
      shown.push(document.getElementById('level').textContent);
    }
    return shown;
  }, n);
  levels.forEach(({faces}, i) => {
    assert.equal(nFacesOf(counts[i]), faces, `level ${i}`);
    assert.equal(nFacesOf(counts[2 * n + 1 - i]), faces, `level ${i}, on the way back`);
  });
}

/** The level that is drawn is that of the file that `replay` writes. */
async function looksLikeItsResult(page) {
  await page.selectOption('#layout', 'result');
  await page.selectOption('#result', '0');
  const level = await pixels(page);
  await page.selectOption('#result', '1');
  const result = await pixels(page);
  const difference = Math.abs(level.halves[0].shown - result.halves[0].shown);
  assert.ok(difference <= 0.002 * level.nPixels, 'the last level is not where the result is');
}

async function movesContinuously(page) {
  await page.selectOption('#movement', 'continuous');
  const at = async (place) => {
    await page.evaluate((share) => window.whittle.player.goTo(share), place);
    return page.evaluate(() => Array.from(window.whittle.results[0].position.array));
  };
  const places = [];
  for (let i = 0; i <= 20; ++i) places.push(await at(0.5 + i / 2000));
  let farthest = 0;
  for (let i = 1; i < places.length; ++i) {
    for (let k = 0; k < places[i].length; ++k) farthest = Math.max(farthest, Math.abs(places[i][k] - places[i - 1][k]));
  }
  assert.ok(farthest < 0.05, `a vertex jumps: ${farthest}`);
  await page.selectOption('#movement', 'steps');
}

async function playsBothWays(page) {
  const place = () => page.evaluate(() => window.whittle.player.place);
  await page.evaluate(() => window.whittle.player.goTo(0.5));
  await page.click('#play');
  await page.waitForFunction(() => window.whittle.player.place > 0.52);
  await page.click('#play');
  const middle = await place();
  await page.click('#back');
  await page.waitForFunction((from) => window.whittle.player.place < from, middle);
  await page.click('#back');
  await page.click('#faster');
  assert.match(await text(page, 'speed'), /2/);
  await page.click('#slower');
  await page.click('#slower');
  assert.match(await text(page, 'speed'), /1\/2/);
}

async function hasEveryView(page) {
  const seen = new Map();
  const note = async (what) => {
    const {halves} = await pixels(page);
    const sum = `${halves[0].sum} ${halves[1].sum}`;
    assert.ok(halves[0].shown + halves[1].shown > 500, `${what} is empty`);
    assert.ok(!seen.has(sum), `${what} looks like ${seen.get(sum)}`);
    seen.set(sum, what);
  };
  await page.evaluate(() => window.whittle.player.goTo(0.9));
  for (const layout of ['beside', 'original', 'result']) {
    await page.selectOption('#layout', layout);
    await note(layout);
  }
  await page.selectOption('#layout', 'over');
  for (const ghost of ['transparent', 'edges', 'points']) {
    await page.selectOption('#ghost', ghost);
    await note(`over, ${ghost}`);
  }
  await page.selectOption('#layout', 'beside');
  await page.selectOption('#shading', 'smooth');
  await note('smooth');
  await page.check('#edges');
  await note('edges');
  await page.uncheck('#edges');
  for (const colour of ['valence', 'shape', 'error']) {
    await page.selectOption('#colour', colour);
    await note(colour);
    assert.ok((await text(page, 'legend')).length > 10, `${colour} has a legend`);
  }
  await page.selectOption('#top', '0.1');
  await note('a tenth of the error');
}

async function obeysKeys(page) {
  await page.focus('#canvas');
  let last = JSON.stringify(await pixels(page));
  for (const key of ['ArrowLeft', 'ArrowUp', 'Shift+ArrowRight', '+', '-', '0', 's', 'e', 'c', '2', '3', '4', '1']) {
    await page.keyboard.press(key);
    const now = JSON.stringify(await pixels(page));
    assert.notEqual(now, last, `the key ${key} changes nothing`);
    last = now;
  }
  const place = () => page.evaluate(() => window.whittle.player.place);
  await page.evaluate(() => window.whittle.player.goTo(0.5));
  await page.keyboard.press('.');
  assert.ok(Math.abs(await place() - 0.501) < 1e-9);
  await page.keyboard.press(',');
  await page.keyboard.press(',');
  assert.ok(Math.abs(await place() - 0.499) < 1e-9);
  await page.keyboard.press('>');
  assert.match(await text(page, 'speed'), /2/);
  await page.keyboard.press('<');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.whittle.player.place > 0.51);
  await page.keyboard.press(' ');
  await page.keyboard.press('b');
  await page.waitForFunction(() => window.whittle.player.direction < 0 && window.whittle.player.place < 0.51);
  await page.keyboard.press('b');
  // Every control can be reached with Tab, and has a name.
  const nControls = await page.$$eval('select, input, button, summary, canvas', (all) => all.filter((e) => e.offsetParent !== null && !e.disabled).length);
  const reached = new Set();
  for (let i = 0; i < 2 * nControls; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.tagName));
  }
  reached.delete('BODY');
  assert.ok(reached.size >= nControls, `${reached.size} of ${nControls} controls are reached by Tab`);
  const nameless = await page.$$eval('select, input', (all) => all.filter((e) => (!e.labels || e.labels.length === 0) && !e.ariaLabel).map((e) => e.id));
  assert.deepEqual(nameless, []);
}

async function fitsANarrowWindow(page) {
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(overflow <= 0, `${overflow} pixels wider than the window`);
  const {halves} = await pixels(page);
  assert.ok(halves[0].shown > 200 && halves[1].shown > 200);
  const shares = await page.$$eval('.label', (labels) => labels.map((label) => label.offsetHeight / window.whittle.view.boxes()[0].height));
  assert.ok(Math.max(...shares) < 0.3, `labels take ${shares} of the height of their meshes`);
}

/** All of the meshes is in the picture, beside and below each other. */
async function fitsThePicture(page) {
  for (const layout of ['original', 'over', 'beside']) {
    await page.selectOption('#layout', layout);
    await drawn(page);
    const isFree = await page.evaluate(({data, width, height}) => {
      const colours = new Uint32Array(data.buffer);
      const sides = Array.from({length: height}, (_, y) => [colours[y * width], colours[(y + 1) * width - 1]]).flat();
      return sides.every((colour) => colour === colours[0]);
    }, await pixelsOfCanvas(page));
    assert.ok(isFree, `${layout}: meshes reach out of the picture`);
  }
}

/** No text of the plots is smaller than that of a footnote. */
async function hasLegiblePlots(page) {
  const heights = await page.$$eval('#charts text:not([transform], :empty)', (texts) => texts.map((text) => text.getBoundingClientRect().height));
  assert.ok(heights.length > 10 && Math.min(...heights) > 8, `text of ${Math.min(...heights)} pixels`);
}

/** At 1,000 pixels of both surfaces, the colour is that of the exact distance of what is seen there. */
async function hasRightErrors(page, panes = [0, 1]) {
  await page.selectOption('#colour', 'error');
  const off = [];
  for (const [turn, zoom, shading] of [[0, 1, 'flat'], [2, 0.5, 'flat'], [1, 0.4, 'smooth'], [1, 5, 'flat']]) {
    await page.selectOption('#shading', shading);
    await page.evaluate(([angle, factor]) => {
      window.whittle.view.rotate(angle, 0);
      window.whittle.view.zoom(factor);
    }, [turn, zoom]);
    await drawn(page);
    for (const pane of panes) off.push(...await stepsOff(page, pane, 125));
  }
  const worst = Math.max(...off);
  const nWrong = off.filter((steps) => steps > 0.1).length;
  console.log(`errors: the colours of ${nWrong} of ${off.length} pixels are off, the worst by ${worst.toFixed(3)} steps of the scale`);
  assert.equal(nWrong, 0, `${nWrong} colours are more than a tenth of a step off, the worst by ${worst} steps`);
}

async function saysWhatIsClicked(page) {
  await page.selectOption('#layout', 'original');
  await drawn(page);
  const box = await (await page.$('#canvas')).boundingBox();
  for (const x of [0.5, 0.42, 0.58, 0.35, 0.65]) {
    await page.mouse.click(box.x + x * box.width, box.y + 0.5 * box.height);
    await page.waitForTimeout(200);
    if (/distance/.test(await text(page, 'status'))) return;
  }
  assert.fail(`a click says: ${await text(page, 'status')}`);
}

async function main() {
  const browser = await openBrowser(nodeModules, chromium, folder);
  withPage = browser.withPage;
  await withPage('recording.html', async (page) => {
    await showsBothMeshes(page);
    await showsEachLevel(page, readJson('levels.json').levels);
    await page.evaluate(() => window.whittle.player.goTo(1));
    await looksLikeItsResult(page);
  });
  await withPage('recording.html', movesContinuously);
  await withPage('recording.html', playsBothWays);
  await withPage('recording.html', hasEveryView, {hash: '#result=1'});
  await withPage('recording.html', obeysKeys);
  await withPage('recording.html', fitsANarrowWindow, {width: 360, height: 740});
  await withPage('nonmanifold.html', fitsThePicture, {width: 360, height: 740});
  for (const width of [360, 800, 1366, 1920]) await withPage('recording.html', hasLegiblePlots, {width, height: 740});
  await withPage('joined.html', (page) => showsEachLevel(page, readJson('cubes_levels.json').levels));
  await withPage('flipped.html', async (page) => {
    await showsEachLevel(page, readJson('terrain_levels.json').levels);
    await page.evaluate(() => window.whittle.player.goTo(1));
    await looksLikeItsResult(page);
  });
  await withPage('errors.html', (page) => hasRightErrors(page), desktop);
  await withPage('recording.html', async (page) => { // a level has colours, too
    await page.evaluate(() => window.whittle.playing.stopAt(0.97));
    await hasRightErrors(page, [1]);
  }, desktop);
  await withPage('errors.html', saysWhatIsClicked, {hash: '#colour=error'});
  await withPage('why.html', async (page) => {
    assert.match(await text(page, 'reasons'), /150 by topology/);
    assert.match(await text(page, 'advice'), /--topology free/);
    const marked = await pixels(page);
    await page.uncheck('#refused');
    assert.notDeepEqual(await pixels(page), marked, 'refused pairs are not drawn');
    assert.ok(await page.isHidden('#reasons'));
  });
  await withPage('errors.html', textured.offersShapesAlone);
  await withPage('gltf.html', textured.showsTheTextureOfGltf);
  await withPage('shifted.html', textured.saysHowFarItsTextureIsOff, {hash: '#colour=texcoord'});
  await withPage('square.obj.html', textured.showsItsTexture);
  await withPage('fine.obj.html', textured.showsItsTextureWhileItMoves);
  await withPage('broken.obj.html', textured.showsNoBrokenTexture);
  await withPage('coloured.ply.html', textured.showsItsColours);
  const backgrounds = {};
  for (const colorScheme of ['light', 'dark']) {
    await withPage('errors.html', async (page) => {
      await showsBothMeshes(page);
      backgrounds[colorScheme] = (await pixels(page)).background[0];
    }, {...desktop, colorScheme});
  }
  assert.ok(backgrounds.light > 150 && backgrounds.dark < 100, `backgrounds: ${JSON.stringify(backgrounds)}`);
  await withPage('markup.html', async (page) => {
    assert.match(await text(page, 'left-label'), /^<img src=x onerror=alert\(1\)><script>/);
    assert.match(await page.title(), /^<img src=x/);
    assert.equal(await page.$('img'), null);
  });
  await browser.close();
  console.log('the pages are as they should be');
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
