// Checks of the pages that show textures, colours and normals (textured_files.cjs).
'use strict';
const assert = require('assert/strict');
const {pixelsOfCanvas} = require('./canvas.cjs');
const {quarters, factor, shift, vertexColour} = require('./textured_files.cjs');

const decoded = (part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
const encoded = (part) => part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055;
const times = (colour, by) => colour.map((part, d) => 255 * encoded(decoded(part / 255) * by[d]));

/** Of a surface that is seen straight on (shaders.js). */
const light = 0.6 + 0.4 * (0.35 + 0.5 + 0.15 * 0.45);

const options = (page, id) => page.$$eval(`#${id} option`, (all) => all.filter(({disabled}) => !disabled).map(({value}) => value));

/** Looks at the squares straight on. */
const lookStraight = (page) => page.evaluate(() => {
  const {view} = window.whittle;
  const distance = view.camera.position.distanceTo(view.center);
  view.camera.position.copy(view.center);
  view.camera.position.z += distance;
  view.controls.update();
  return window.whittle.drawn();
});

/** \return of each pane the colours in the middle of its quarters, as `quarters`: of what is drawn now */
const drawnQuarters = async (page) => page.evaluate((canvas) => {
  const {view} = window.whittle;
  const ratio = canvas.width / view.sharpSize().width;
  return view.sharpBoxes().map(({left, width, height}) => [[-1, 1], [1, 1], [-1, -1], [1, -1]].map(([x, y]) => {
    const seen = view.center.clone();
    seen.x += 0.25 * x; // the square is 1 wide in the unit of the page
    seen.y += 0.25 * y;
    seen.project(view.camera);
    const [column, row] = [left + (seen.x + 1) / 2 * width, (1 - seen.y) / 2 * height].map((at) => Math.floor(ratio * at));
    const i = 4 * (column + row * canvas.width);
    return Array.from(canvas.data.subarray(i, i + 3));
  }));
}, await pixelsOfCanvas(page));

async function coloursOfQuarters(page) {
  await lookStraight(page);
  return drawnQuarters(page);
}

function assertColours(found, expected, what) {
  found.forEach((pane, i) => pane.forEach((colour, k) => colour.forEach((part, d) => {
    assert.ok(Math.abs(part - expected[k][d]) <= 2, `${what}: pane ${i}, quarter ${k} is ${colour}, not ${expected[k]}`);
  })));
}

const lit = (colours) => colours.map((colour) => colour.map((part) => light * part));

/** \param by the linear factor of the material */
async function showsItsTexture(page, by = [1, 1, 1]) {
  assert.equal(await page.$eval('#colour', ({value}) => value), 'material');
  assertColours(await coloursOfQuarters(page), lit(quarters.map((colour) => times(colour, by))), 'texture');
}

/** Fewer faces are drawn then. */
async function showsItsTextureWhileItMoves(page) {
  await lookStraight(page);
  const faces = () => page.evaluate(() => window.whittle.original.faces.geometry.getIndex().count / 3);
  const nFaces = await faces();
  await page.evaluate(async () => {
    const {motion} = window.whittle;
    motion.goOn();
    motion.roughness = 1;
    clearTimeout(motion.timer); // it goes on moving
    window.whittle.draw();
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  assert.ok(await faces() < nFaces / 3, `${await faces()} of ${nFaces} faces are drawn`);
  assertColours((await drawnQuarters(page)).slice(0, 1), lit(quarters), 'moving texture');
  await page.evaluate(() => window.whittle.drawn());
  assert.equal(await faces(), nFaces);
}

async function showsTheTextureOfGltf(page) {
  await showsItsTexture(page, factor);
  const colours = ['none', 'material', 'normals', 'error', 'normal', 'texcoord', 'valence', 'shape'];
  assert.deepEqual(await options(page, 'colour'), colours);
  await page.selectOption('#colour', 'normals');
  for (const shading of ['flat', 'smooth', 'file']) {
    await page.selectOption('#shading', shading);
    assertColours(await coloursOfQuarters(page), Array(4).fill([128, 128, 255]), `normals, ${shading}`);
  }
}

async function saysHowFarItsTextureIsOff(page) {
  const box = await (await page.$('#canvas')).boundingBox();
  await page.evaluate(() => window.whittle.drawn());
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 0.5 * box.height);
  await page.waitForFunction(() => /off by/.test(document.getElementById('status').textContent));
  const status = await page.$eval('#status', ({textContent}) => textContent);
  assert.equal(Number(/off by ([\d.]+)/.exec(status)[1]), shift);
  assert.match(await page.$eval('#legend', ({textContent}) => textContent), /texture coordinates/);
}

async function showsItsColours(page) {
  assert.equal(await page.$eval('#colour', ({value}) => value), 'colours');
  assertColours(await coloursOfQuarters(page), lit(Array(4).fill(vertexColour)), 'vertex colours');
}

/** A texture that is no image doesn't hinder the rest. */
async function showsNoBrokenTexture(page) {
  assertColours(await coloursOfQuarters(page), lit(Array(4).fill([255, 255, 255])), 'broken texture');
}

async function offersShapesAlone(page) {
  assert.deepEqual(await options(page, 'colour'), ['none', 'error', 'valence', 'shape']);
  assert.deepEqual(await options(page, 'shading'), ['flat', 'smooth']);
  assert.equal(await page.$eval('#colour', ({value}) => value), 'none');
}

module.exports = {offersShapesAlone, saysHowFarItsTextureIsOff, showsItsColours, showsItsTexture, showsItsTextureWhileItMoves, showsNoBrokenTexture, showsTheTextureOfGltf};
