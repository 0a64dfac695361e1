// use.cjs NODE_MODULES CHROMIUM FOLDER [PAGE...]: opens the pages that run.sh has written, or some of them, and uses each
// control of each, by mouse, keyboard and touch. WHITTLE_WINDOW=1366x768 has another size; it takes longer.
'use strict';
const assert = require('assert/strict');
const {known, usesTheKeys, usesThePlayer, usesTheView} = require('./controls.cjs');
const {openBrowser} = require('./pages.cjs');

const [nodeModules, chromium, folder, ...chosen] = process.argv.slice(2);

const [begin, middle, end] = [0, 0.5037, 1]; // places of the slider; at this middle, vertices are on their way
const everyState = [begin, middle, end].flatMap((place) => [0, 1, -1].map((direction) => [place, direction]));
const someStates = [[begin, -1], [middle, 0], [middle, 1]];
const oneState = [[middle, 0]];

/** Pages, what is true of them (control_rules.cjs), and how they are used. */
const pages = [
  {name: 'blob.rec.html', views: ['mouse'], players: {mouse: everyState, keys: someStates, touch: someStates}}, // a recording alone
  {name: 'recording.html', views: ['keys'], players: {mouse: oneState}, areKeysUsed: true},
  {name: 'flipped.html', views: [], players: {mouse: oneState}},
  {name: 'square.rec.html', about: {isFlat: true}, views: ['mouse'], players: {mouse: someStates}}, // glTF with its recording
  {name: 'why.html', views: ['mouse'], players: {keys: oneState}, areKeysUsed: true}, // of `simplify --page`, with refused pairs
  {name: 'gltf.html', about: {isFlat: true, isAlike: true}, views: ['touch'], players: {mouse: oneState}, areKeysUsed: true},
  {name: 'shifted.html', about: {isFlat: true, isAlike: true}, views: ['mouse']},
  {name: 'coloured.ply.html', about: {isFlat: true, isAlike: true}, views: ['mouse']},
  {name: 'nonmanifold.html', views: ['mouse']}, // with borders and non-manifold edges
  {name: 'levels.html', views: ['mouse']}, // several results
  {name: 'one.html', views: ['keys'], areKeysUsed: true}, // a mesh alone, with borders and non-manifold edges
];
const [width, height] = (process.env.WHITTLE_WINDOW ?? '320x460').split('x').map(Number); // pictures are drawn often

async function uses({name, about = {}, players = {}, views, areKeysUsed = false}, withPage, used) {
  const ways = [...Object.entries(players).map(([by, states]) => [usesThePlayer, by, states]), ...views.map((by) => [usesTheView, by]),
    ...areKeysUsed ? [[usesTheKeys, 'keys']] : []];
  for (const [use, by, states] of ways) {
    const start = Date.now();
    try {
      await withPage(name, (page) => use(page, {by, about, states, used}), {width, height, hasTouch: by === 'touch'});
    } catch (error) {
      throw new Error(`${name}: ${error.message}`, {cause: error});
    }
    console.log(`${name}, ${use.name} by ${by}: ${((Date.now() - start) / 1000).toFixed(1)} s`);
  }
}

async function main() {
  const browser = await openBrowser(nodeModules, chromium, folder);
  const used = new Set();
  for (const page of pages) if (chosen.length === 0 || chosen.includes(page.name)) await uses(page, browser.withPage, used);
  if (chosen.length === 0) assert.deepEqual([...used].sort(), [...known].sort(), 'a control is on none of the pages');
  await browser.close();
}

main().catch((error) => {
  console.error(error.message);
  console.error(error);
  process.exit(1);
});
