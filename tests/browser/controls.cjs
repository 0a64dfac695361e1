// Every control of a page, used with the mouse as a person uses it: each option of a list, each button, each box, the
// slider, the keys and the drawing, in each state of the player. A control that isn't known here fails the test.
'use strict';
const assert = require('assert/strict');
const {pixelsOfCanvas} = require('./canvas.cjs');

/** What a person sees of the page: the picture, and what the texts and controls say. */
async function seen(page) {
  await page.evaluate(() => window.whittle.drawn());
  const pixels = await page.evaluate(({data}) => {
    let hash = 0;
    for (let i = 0; i < data.length; i += 4) hash = (Math.imul(hash, 31) + data[i] * 65536 + data[i + 1] * 256 + data[i + 2]) | 0;
    return hash;
  }, await pixelsOfCanvas(page));
  return {pixels, ...await state(page)};
}

/** Without the picture. */
const state = (page) => page.evaluate(() => {
  const text = (id) => document.getElementById(id).textContent;
  const {player} = window.whittle;
  return {
    labels: text('left-label') + text('right-label'), legend: document.getElementById('legend').hidden ? '' : text('legend'),
    level: text('level'), speed: text('speed'), play: text('play'), back: text('back'), status: text('status'),
    place: player?.place, direction: player?.direction, camera: window.whittle.view.key(),
  };
});

const differ = (a, b, key) => assert.notDeepEqual(a[key], b[key], `${key} stays as it was`);

/** What has to change where an option is chosen in a list. */
const lists = {
  layout: (a, b, {isFlat}) => differ(a, b, isFlat ? 'labels' : 'pixels'), // equal surfaces over each other look as one
  result: (a, b) => differ(a, b, 'labels'),
  ghost: (a, b, {isFlat}) => isFlat || differ(a, b, 'pixels'),
  shading: (a, b, {isFlat}) => isFlat || differ(a, b, 'pixels'),
  colour: (a, b) => a.pixels === b.pixels && differ(a, b, 'legend'), // where nothing is off, errors look alike
  // 99 % of the surface may be as far off as all of it.
  top: (a, b, about, value) => ['usual', '1'].includes(value) || differ(a, b, 'legend'),
  up: (a, b) => differ(a, b, 'camera'), // a square may look the same
  // Between two levels vertices may lie where they do at one of them; what is shown is looked at in movesContinuously.
  movement: () => {},
  spacing: (a, b) => a.place === 0 || a.place === 1 || differ(a, b, 'level'),
};

const boxes = {
  edges: (a, b) => differ(a, b, 'pixels'),
  borders: (a, b) => differ(a, b, 'pixels'),
  nonmanifold: (a, b) => differ(a, b, 'pixels'),
  refused: (a, b) => differ(a, b, 'pixels'),
};

/** It comes to the end, and stands still there. */
async function ends(page, direction) {
  await page.waitForFunction(() => window.whittle.player.direction === 0);
  const after = await state(page);
  assert.equal(after.place, direction > 0 ? 1 : 0, 'it comes to the end');
  assert.deepEqual([after.play, after.back], ['Play', 'Backwards']);
}

/** The place goes this way while the page plays, and comes to an end. \param before the button was clicked */
async function plays(page, before, direction) {
  const isAtEnd = direction > 0 ? before.place >= 1 : before.place <= 0;
  const begin = isAtEnd ? 1 - before.place : before.place;
  if (!isAtEnd && (direction > 0 ? 1 - begin : begin) < 0.3) return ends(page, direction); // which may have come already
  await page.waitForFunction(([from, way]) => way * (window.whittle.player.place - from) > 0.002, [begin, direction]);
  const now = await state(page);
  assert.equal(now.direction, direction);
  assert.equal(direction > 0 ? now.play : now.back, 'Pause');
  assert.equal(direction > 0 ? now.back : now.play, direction > 0 ? 'Backwards' : 'Play');
  await page.evaluate((way) => window.whittle.player.goTo(way > 0 ? 0.999 : 0.001), direction);
  await ends(page, direction);
}

async function standsStill(page) {
  const before = await state(page);
  assert.equal(before.direction, 0);
  await page.waitForTimeout(100);
  assert.equal((await state(page)).place, before.place);
}

/** What a click on a button does. \param before it was clicked */
const buttons = {
  play: (page, before) => before.direction > 0 ? standsStill(page) : plays(page, before, 1),
  back: (page, before) => before.direction < 0 ? standsStill(page) : plays(page, before, -1),
  next: async (page, before) => {
    await standsStill(page);
    assert.ok((await state(page)).place > before.place || before.direction < 0, 'a step on goes on');
  },
  previous: async (page, before) => {
    await standsStill(page);
    assert.ok((await state(page)).place < before.place || before.direction > 0, 'a step back goes back');
  },
  faster: async (page, before) => differ(before, await state(page), 'speed'),
  slower: async (page, before) => differ(before, await state(page), 'speed'),
  fit: async (page) => {
    const fitted = await seen(page);
    await page.evaluate(() => window.whittle.view.zoom(0.5));
    assert.notEqual((await seen(page)).pixels, fitted.pixels);
    await page.click('#fit');
    assert.equal((await seen(page)).pixels, fitted.pixels, 'fit shows what it showed');
  },
};

/** A point of the left pane, on the screen. \param share of the way from its left to its right */
async function pointOfPane(page, share = 0.5) {
  const canvas = await page.$('#canvas');
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  return [box.x + box.width * share / await page.evaluate(() => window.whittle.view.panes), box.y + box.height / 2];
}

/** Where there is a surface: a mesh may have a hole in the middle. */
async function saysWhatIsClicked(page) {
  for (const share of [0.5, 0.42, 0.58, 0.35, 0.65]) {
    await page.mouse.click(...await pointOfPane(page, share));
    await page.waitForTimeout(300);
    if ((await state(page)).status.includes('(')) return;
  }
  assert.fail('a click says nothing');
}

/** A drag, the wheel, the other button, and a click. */
async function drawingIsMoved(page) {
  const drags = async (button) => {
    const middle = await pointOfPane(page);
    await page.mouse.move(...middle);
    await page.mouse.down({button});
    await page.mouse.move(middle[0] + 40, middle[1] + 25, {steps: 3});
    await page.mouse.up({button});
  };
  let last = await seen(page);
  const changes = async (what) => {
    const now = await seen(page);
    assert.notEqual(now.pixels, last.pixels, `${what} changes nothing`);
    last = now;
  };
  await drags('left');
  await changes('a drag');
  await drags('right');
  await changes('a drag with the right button');
  await page.mouse.move(...await pointOfPane(page));
  await page.mouse.wheel(0, 240);
  await changes('the wheel');
  await page.click('#fit');
  await saysWhatIsClicked(page);
  await page.click('#canvas', {position: {x: 2, y: 2}});
  await page.waitForFunction(() => document.getElementById('status').textContent === '');
}

/** The slider goes to where it is clicked, with the keys to its ends; then the page stands still. */
async function sliderIsMoved(page) {
  const box = await (await page.$('#slider')).boundingBox();
  for (const share of [0.25, 0.75]) {
    await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
    await standsStill(page);
    assert.ok(Math.abs((await state(page)).place - share) < 0.05, `a click at ${share} of the slider goes to ${(await state(page)).place}`);
  }
  for (const [key, place] of [['Home', 0], ['End', 1]]) {
    await page.press('#slider', key);
    assert.equal((await state(page)).place, place, `${key} on the slider`);
  }
}

const isUsable = (control) => control.isVisible().then(async (isVisible) => isVisible && control.isEnabled());

/** \param about what is true of the page */
async function useList(page, id, about) {
  const options = await page.$$eval(`#${id} option`, (all) => all.filter((option) => !option.disabled).map(({value}) => value));
  const first = await page.$eval(`#${id}`, ({value}) => value);
  let before = await seen(page);
  for (const value of [...options.filter((option) => option !== first), first]) {
    await page.selectOption(`#${id}`, value);
    const after = await seen(page);
    try {
      if (options.length > 1) lists[id](before, after, about, value);
    } catch (error) {
      throw new Error(`${id}: ${value}: ${error.message}`);
    }
    before = after;
  }
}

async function useBox(page, id) {
  const before = await seen(page);
  await page.click(`#${id}`);
  const after = await seen(page);
  boxes[id](before, after);
  await page.click(`#${id}`);
  assert.equal((await seen(page)).pixels, before.pixels, `${id} can't be taken back`);
}

async function useDetails(page) {
  const isOpen = () => page.$eval('details', ({open}) => open);
  const before = await isOpen();
  await page.click('summary');
  assert.equal(await isOpen(), !before);
  await page.click('summary');
}

/** Uses each control that is there and works in this state. \param use 'looks' those that choose what is drawn, 'player'
    those of the recording \param reach brings the page into the state \return the names of those used */
async function usesEachControl(page, use, reach, about = {}) {
  const used = [];
  for (const control of await page.$$('select, input, button, summary, canvas')) {
    const {id, tag, isOfPlayer} = await control.evaluate((e) => ({id: e.id, tag: e.tagName, isOfPlayer: e.closest('#player') !== null}));
    if (isOfPlayer !== (use === 'player')) continue;
    await reach();
    if (!await isUsable(control)) continue;
    used.push(id || tag);
    try {
      if (tag === 'SUMMARY') await useDetails(page);
      else if (tag === 'CANVAS') await drawingIsMoved(page);
      else if (id === 'slider') await sliderIsMoved(page);
      else if (lists[id]) await useList(page, id, about);
      else if (boxes[id]) await useBox(page, id);
      else if (buttons[id]) {
        const before = await state(page);
        await control.click();
        await buttons[id](page, before);
      } else assert.fail('this test does not know it');
    } catch (error) {
      throw new Error(`${id || tag}, ${use}, ${JSON.stringify(about)}: ${error.message}`);
    }
  }
  return used;
}

/** Brings the player to a place, and lets it play in a direction. */
const reachPlace = (page, place, direction) => async () => {
  await page.evaluate(([at, way]) => {
    const {player} = window.whittle;
    player.setSpeed(1);
    window.whittle.showPlace(at);
    if (way !== 0) window.whittle.play(way);
  }, [place, direction]);
};

/** The controls of a recording, at these places, standing still and playing. */
async function playerWorks(page, {places = [0, 0.5, 1], directions = [0, 1, -1]} = {}) {
  const used = new Set();
  for (const place of places) {
    for (const direction of directions) {
      for (const id of await usesEachControl(page, 'player', reachPlace(page, place, direction), {place, direction})) used.add(id);
    }
  }
  assert.deepEqual([...used].sort(), ['back', 'faster', 'movement', 'next', 'play', 'previous', 'slider', 'slower', 'spacing']);
  for (const [speed, id] of [[64, 'faster'], [1 / 64, 'slower']]) {
    await page.evaluate((value) => { window.whittle.player.setSpeed(value); window.whittle.showLevel(); }, speed);
    assert.ok(await page.isDisabled(`#${id}`), `${id} has no more to give`);
  }
}

/** The controls of what is drawn, in each layout that has other ones. */
async function looksWork(page, about = {}) {
  const reach = (layout, colour) => async () => {
    if (await page.isVisible('#layout')) await page.selectOption('#layout', layout);
    await page.selectOption('#colour', colour);
    await page.click('#fit');
  };
  const colours = await page.$$eval('#colour option', (all) => all.filter((option) => !option.disabled).map(({value}) => value));
  const used = new Set();
  const note = (ids) => ids.forEach((id) => used.add(id));
  note(await usesEachControl(page, 'looks', reach('beside', colours.includes('error') ? 'error' : 'none'), {...about, layout: 'beside'}));
  if (await page.isVisible('#layout')) {
    note(await usesEachControl(page, 'looks', reach('over', 'none'), {...about, layout: 'over'}));
  }
  return [...used].sort();
}

/** The keys that the page lists, each with what it changes. \param listed the text of the list */
async function listsItsKeys(page) {
  const listed = (await page.$$eval('details dt', (all) => all.map((e) => e.textContent))).join(' ');
  for (const key of ['r', 'g', 'u', 'c', 't', 's', 'e', 'o', 'n', 'p', 'b', 'm', 'l']) {
    assert.match(listed, new RegExp(`(^|[ ,])${key}([ ,]|$)`), `${key} is not in the list`);
    const has = await page.evaluate((name) => Boolean(window.whittle.actionOf(name, false)), key);
    assert.ok(has, `the key ${key} does nothing`);
  }
  const value = (id) => page.$eval(`#${id}`, (e) => e.type === 'checkbox' ? e.checked : e.value);
  await page.selectOption('#layout', 'over');
  await page.focus('#canvas');
  const keys = {r: 'result', g: 'ghost', u: 'up', c: 'colour', s: 'shading', e: 'edges', o: 'borders', n: 'nonmanifold', m: 'movement', l: 'spacing'};
  for (const [key, id] of Object.entries(keys)) {
    const isUseful = await page.$eval(`#${id}`, (e) => !e.disabled && e.closest('[hidden]') === null);
    const before = await value(id);
    await page.keyboard.press(key);
    assert.equal(await value(id) !== before, isUseful, `the key ${key}`);
  }
  await page.selectOption('#layout', 'original');
  await page.click('#fit');
  await page.focus('#canvas');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.getElementById('status').textContent.includes('('));
}

/** One finger rotates. */
async function obeysAFinger(page) {
  const before = await seen(page);
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send('Input.dispatchTouchEvent', {type, touchPoints: points});
  const [x, y] = await pointOfPane(page);
  await touch('touchStart', [{x, y}]);
  await touch('touchMove', [{x: x + 30, y: y + 10}]);
  await touch('touchMove', [{x: x + 60, y: y + 20}]);
  await touch('touchEnd', []);
  const turned = await seen(page);
  assert.notEqual(turned.pixels, before.pixels, 'a finger changes nothing');
  await touch('touchStart', [{x, y}, {x: x + 40, y}]);
  await touch('touchMove', [{x: x - 20, y}, {x: x + 60, y}]);
  await touch('touchMove', [{x: x - 40, y}, {x: x + 80, y}]);
  await touch('touchEnd', []);
  assert.notEqual((await seen(page)).pixels, turned.pixels, 'two fingers change nothing');
}

module.exports = {playerWorks, looksWork, listsItsKeys, obeysAFinger};
