// What has to change when a control of the page is used, by its name: its id, or its tag. `before` and `after` are what
// `look` in visitor.cjs sees. `about` says what is true of the page: `isFlat`, all is in one plane; `isAlike`, the
// result looks like the original.
'use strict';
const assert = require('assert/strict');

const differ = (before, after, key) => assert.notEqual(after[key], before[key], `${key} stays as it was`);
const changes = (key) => (before, after) => differ(before, after, key);
const picture = changes('picture');
const stays = (before, after, key) => assert.equal(after[key], before[key], `${key} changes`);

/** Whether the player is less than a level from the first or the last: there, all spacings may show the same one. */
const isNearAnEnd = ({place, nLevels}) => Math.min(place, 1 - place) * nLevels < 1;

/** Lists: after another option was chosen. */
const lists = {
  layout(before, after, {isAlike}) {
    assert.notEqual([after.labels, after.split].join(), [before.labels, before.split].join(), 'labels and line stay as they were');
    if (!isAlike) differ(before, after, 'picture');
  },
  result(before, after) {
    differ(before, after, 'labels');
    const counts = ({labels}) => labels.match(/[\d,]+ faces?/g).join();
    if (counts(before) !== counts(after)) differ(before, after, 'picture'); // the last level is the result
  },
  ghost: picture,
  shading: (before, after, {isFlat}) => isFlat || differ(before, after, 'picture'),
  colour: (before, after) => assert.ok(after.picture !== before.picture || after.legend !== before.legend, 'nothing changes'),
  top: (before, after, {isFlat}) => isFlat || differ(before, after, 'legend'),
  up: (before, after, {isFlat}) => isFlat || differ(before, after, 'picture'), // a square can look the same
  movement: (before, after, {isFlat}) => isFlat || before.place === 0 || before.place === 1 || differ(before, after, 'picture'),
  spacing: (before, after) => isNearAnEnd(before) || differ(before, after, 'level'),
};

const boxes = {faces: picture, edges: picture, borders: picture, nonmanifold: picture, refused: picture};

/** What is seen while it plays and after. \param before the button was pressed \param page has `look` and `wait` */
async function plays(page, before, direction) {
  const isAtEnd = direction > 0 ? before.place === 1 : before.place === 0;
  const from = isAtEnd ? 1 - before.place : before.place;
  if ((direction > 0 ? 1 - from : from) < 0.2) return ends(page, direction); // it may be there already
  await page.wait(([begin, way]) => way * (document.getElementById('slider').value / 1000 - begin) > 0.005, [from, direction], 'it plays');
  const on = await page.look();
  assert.equal(on.direction, direction, 'the button says what it does');
  assert.equal(on.play, direction > 0 ? 'Pause' : 'Play');
  assert.equal(on.back, direction < 0 ? 'Pause' : 'Play backwards');
  await page.wait(([text]) => document.getElementById('level').textContent !== text, [on.level], 'the level goes on');
  if (on.isRecordingShown) differ(on, await page.look(), 'labels');
  await page.jumpTo(direction > 0 ? 0.999 : 0.001);
  await ends(page, direction);
}

async function ends(page, direction) {
  await page.wait(([end]) => Number(document.getElementById('slider').value) === end, [direction > 0 ? 1000 : 0], 'it comes to the end');
  await standsStill(page, 'at the end');
}

async function standsStill(page, when) {
  await page.wait(() => ['play', 'back'].every((id) => document.getElementById(id).getAttribute('aria-label') !== 'Pause'), [],
    `it stands still ${when}`);
  const before = await page.look();
  await page.frames();
  const after = await page.look();
  for (const key of ['place', 'level', 'picture']) stays(before, after, key);
  return after;
}

async function steps(page, before, way) {
  const after = await standsStill(page, 'after a step');
  if (before.direction === 0) {
    assert.ok(way * (after.place - before.place) > 0, 'the slider goes on');
    differ(before, after, 'level');
  }
}

async function changesSpeed(page, before, way) {
  const after = await page.look();
  const speed = ({speed: text}) => text.match(/\d+/g).map(Number).reduce((whole, part) => whole / part);
  assert.equal(speed(after), speed(before) * 2 ** way);
  if (before.direction !== 0) assert.equal(after.direction, before.direction, 'it plays on');
}

/** Buttons: after they were pressed. */
const buttons = {
  play: (page, before) => before.direction > 0 ? standsStill(page, 'after Pause') : plays(page, before, 1),
  back: (page, before) => before.direction < 0 ? standsStill(page, 'after Pause') : plays(page, before, -1),
  next: (page, before) => steps(page, before, 1),
  previous: (page, before) => steps(page, before, -1),
  faster: (page, before) => changesSpeed(page, before, 1),
  slower: (page, before) => changesSpeed(page, before, -1),
  fit: async (page, before) => differ(before, await page.look(), 'picture'), // which was turned before
  worst: findsTheWorst,
  numbers: async (page) => {
    assert.equal((await page.look()).focus, 'tables');
    const isSeen = () => document.getElementById('tables').getBoundingClientRect().top < window.innerHeight / 2 || window.scrollY > 0 &&
      window.scrollY + window.innerHeight >= document.documentElement.scrollHeight - 1;
    assert.ok(await page.page.evaluate(isSeen), 'the page scrolls to the tables');
    await page.page.evaluate(() => window.scrollTo(0, 0));
  },
  help: async (page) => {
    assert.ok((await page.look()).isHelpOpen, 'the list of keys is there');
    assert.equal(await page.page.$eval('#keys', ({scrollTop}) => scrollTop), 0, 'its beginning is seen');
    await page.press('close', 'keys');
    assert.ok(!(await page.look()).isHelpOpen, 'the list of keys is closed');
  },
};

/** It says how far off the worst place is, beside it, and shows it in the colours of the error. */
async function findsTheWorst(page) {
  const isSaid = /^Largest distance ([^ ]+) model units/;
  await page.wait(([source]) => new RegExp(source).test(document.getElementById('status').textContent), [isSaid.source], 'the worst place is told');
  const after = await page.look();
  assert.equal(after.spot, after.status, 'it is told at the spot, too');
  assert.match(after.legend, /distance/);
}

/** After their key was pressed. */
const inputs = {
  split: changes('split'),
  count: (_, after) => assert.equal(after.focus, 'count'),
  limit: (_, after) => assert.equal(after.focus, 'limit'),
};

/** Each key that the page may list: the control that it stands for, or what has to change. */
const keys = {
  'Arrows': picture, '+': picture, '−': picture, '0': 'fit', 'Enter': changes('status'), 'Esc': changes('focus'),
  'c': 'colour', 't': 'top', 's': 'shading', 'u': 'up', 'f': 'faces', 'e': 'edges',
  'o': 'borders', 'n': 'nonmanifold', 'p': 'refused', 'w': 'worst', 'x': 'numbers', '?': 'help', '[': 'split', ']': 'split',
  'j': 'count', 'i': 'limit', 'd': 'save',
  '1': 'layout', '2': 'layout', '3': 'layout', '4': 'layout', '5': 'layout', 'r': 'result', 'g': 'ghost',
  'Space': 'play', 'b': 'back', ',': 'previous', '.': 'next', '<': 'slower', '>': 'faster', 'm': 'movement', 'l': 'spacing',
};

module.exports = {lists, boxes, buttons, inputs, keys, standsStill, differ, stays};
