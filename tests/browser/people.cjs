// people.cjs NODE_MODULES CHROMIUM FOLDER: opens the pages that run.sh has written as people do, on a laptop, a large
// screen and a phone, and asks what they would ask.
'use strict';
const assert = require('assert/strict');
const fs = require('fs');
const {axeViolations, openBrowser} = require('./pages.cjs');
const {Visitor} = require('./visitor.cjs');

const [nodeModules, chromium, folder] = process.argv.slice(2);

const windows = {laptop: {width: 1366, height: 768}, screen: {width: 1920, height: 1080}, phone: {width: 400, height: 800, hasTouch: true}};

/** The boxes of the canvas and of the controls beside and below it that can be used now. */
const boxesOf = (page) => page.evaluate(() => {
  const all = document.querySelectorAll('#viewer button, #viewer input, #viewer select, #canvas, #numbers');
  return [...all].filter((e) => e.offsetParent !== null && e.id !== 'split').map((e) => {
    const {left, top, right, bottom} = e.getBoundingClientRect();
    return {id: e.id, left, top, right, bottom};
  });
});

/** All is in the window without scrolling, nothing covers a control, and the picture has most of the room. */
async function fitsTheWindow(page, {width, height}) {
  const boxes = await boxesOf(page);
  for (const {id, left, top, right, bottom} of boxes) {
    assert.ok(left >= 0 && top >= 0 && right <= width && bottom <= height, `${id} is out of the window: ${[left, top, right, bottom]}`);
  }
  const controls = boxes.filter(({id}) => !['canvas', 'help'].includes(id));
  for (const a of controls) {
    for (const b of controls) {
      const isApart = a === b || a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      assert.ok(isApart, `${a.id} lies over ${b.id}`);
    }
  }
  const canvas = boxes.find(({id}) => id === 'canvas');
  const share = (canvas.right - canvas.left) * (canvas.bottom - canvas.top) / (width * height);
  assert.ok(share > 0.4, `the picture has ${(100 * share).toFixed(0)} % of the window`);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(overflow <= 0, `${overflow} pixels wider than the window`);
}

/** On a phone the meshes are below each other, elsewhere side by side. */
async function placesTheMeshes(page, isPhone) {
  const boxes = await page.evaluate(() => window.whittle.view.boxes());
  if (boxes.length < 2) return;
  const [a, b] = boxes;
  if (isPhone) assert.ok(a.left === b.left && a.bottom === b.height, 'the meshes are below each other');
  else assert.ok(a.bottom === b.bottom && b.left === a.width, 'the meshes are side by side');
}

/** axe finds nothing that is serious. */
async function isAccessible(page, what) {
  const violations = await axeViolations(nodeModules, page);
  const serious = violations.filter(({impact}) => ['serious', 'critical'].includes(impact));
  assert.deepEqual(serious.map(({id, nodes}) => `${id}: ${nodes.map(({html}) => html).slice(0, 3)}`), [], what);
}

/** Every control has a name and says what it does and which key does it. */
async function namesItsControls(page) {
  const untold = await page.$$eval('#viewer button, #viewer input, #viewer select, #numbers', (all) => all.filter((e) => {
    const title = e.closest('[title]')?.title ?? '';
    return !/\(keys? /.test(title) && e.id !== 'slider'; // the slider has the keys of the browser
  }).map(({id}) => id));
  assert.deepEqual(untold, [], 'controls without a tooltip that names their key');
}

const text = (page, id) => page.$eval(`#${id}`, (element) => element.textContent);

/** What people ask of a page that plays a run. */
async function answersQuestions(page) {
  const visitor = new Visitor(page);
  const number = (pattern, from) => Number(pattern.exec(from)[1].replaceAll(',', ''));
  // How many triangles less?
  const label = await text(page, 'right-label');
  const [nFaces, nFewer] = [number(/([\d,]+) faces/, label), number(/([\d,]+) fewer/, label)];
  assert.equal(nFaces + nFewer, number(/([\d,]+) faces/, await text(page, 'left-label')));
  // Which level keeps this error?
  const limit = number(/largest ([\d.e-]+) model units/, label) / 2;
  await page.fill('#limit', String(limit));
  await page.press('#limit', 'Enter');
  const kept = await visitor.look();
  assert.match(kept.status, /faces keep within/);
  assert.ok(number(/largest ([\d.e-]+) model units/, kept.labels) <= limit * 1.005); // three digits are told
  // Where is it worst?
  await page.click('#worst');
  await visitor.wait(() => /^Largest distance/.test(document.getElementById('spot').textContent), [], 'the worst place');
  assert.match((await visitor.look()).legend, /model units/);
  // Play it.
  await page.evaluate(() => window.whittle.playing.stopAt(0));
  await page.click('#play');
  await visitor.wait(() => window.whittle.player.place > 0.05, [], 'it plays');
  await page.click('#play');
  // Save level 500.
  await page.fill('#count', '500');
  await page.press('#count', 'Enter');
  const saved = page.waitForEvent('download');
  await page.click('#save');
  const file = await (await saved).path();
  const count = number(/element face (\d+)/, fs.readFileSync(file, 'latin1'));
  assert.ok(count <= 500 && count >= 498, `${count} faces are saved`);
}

/** Figures are one click away. */
async function givesItsFigures(page) {
  await page.click('#json summary');
  const figures = JSON.parse(await text(page, 'json').then((all) => all.slice(all.indexOf('{'))));
  assert.equal(figures.meshes.length, 2);
  assert.match(await text(page, 'tables'), new RegExp(`Faces.*${figures.meshes[1].faces.toLocaleString('en')}`, 's'));
}

async function main() {
  const {withPage, close} = await openBrowser(nodeModules, chromium, folder);
  for (const [name, window] of Object.entries(windows)) {
    for (const file of ['recording.html', 'errors.html', 'gltf.html', 'one.html', 'why.html', 'levels.html']) {
      for (const hash of ['', '#colour=error&layout=over', '#layout=split']) {
        await withPage(file, async (page) => {
          await fitsTheWindow(page, window);
          if (hash === '') await placesTheMeshes(page, name === 'phone');
        }, {...window, hash}).catch((error) => { throw new Error(`${file}${hash} on a ${name}: ${error.message}`, {cause: error}); });
      }
    }
    for (const colorScheme of ['light', 'dark']) {
      await withPage('recording.html', async (page) => {
        await isAccessible(page, `${name}, ${colorScheme}`);
        await page.click('#help');
        await isAccessible(page, `${name}, ${colorScheme}, keys`);
      }, {...window, hash: '#colour=error', colorScheme});
    }
    await withPage('recording.html', answersQuestions, window);
  }
  await withPage('recording.html', namesItsControls, windows.laptop);
  await withPage('errors.html', givesItsFigures, windows.laptop);
  await close();
  console.log('people find what they look for');
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
