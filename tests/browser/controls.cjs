// Uses every control that a page has, in each of its states, and looks at what changes. What has to change is in
// control_rules.cjs; a control, or a listed key, that isn't there fails the test.
'use strict';
const assert = require('assert/strict');
const fs = require('fs');
const {lists, boxes, buttons, inputs, keys, standsStill, differ, stays} = require('./control_rules.cjs');
const {Visitor} = require('./visitor.cjs');

/** Tries something, and says where if it fails. */
async function trying(what, act) {
  try {
    await act();
  } catch (error) {
    throw new Error(`${what}: ${error.message}`, {cause: error});
  }
}

/** Chooses each option of a list, and what was chosen at first again. */
async function useList(visitor, name, by, about) {
  const first = await visitor.value(name);
  const others = (await visitor.options(name)).filter((value) => value !== first);
  if (others.length === 0) return;
  let before = await visitor.look();
  for (const value of [...others, first]) {
    await trying(value, async () => {
      await visitor.choose(name, value, by);
      const after = await visitor.look();
      lists[name](before, after, about);
      before = after;
    });
  }
}

async function useBox(visitor, name, by) {
  const before = await visitor.look();
  await visitor.press(name, by);
  boxes[name](before, await visitor.look());
  await visitor.press(name, by);
  stays(before, await visitor.look(), 'picture');
}

async function useButton(visitor, name, by) {
  if (name === 'fit') await visitor.page.evaluate(() => window.whittle.view.rotate(0.3, 0.2));
  const before = await visitor.look();
  if (!await visitor.isUsable(name)) return; // it has come to an end meanwhile
  await visitor.press(name, by);
  await buttons[name](visitor, before);
}

const nFacesOf = (text) => Number(/([\d,]+) faces?/.exec(text)[1].replaceAll(',', ''));

/** The file that is saved has the faces of the level that is shown. */
async function useSave(visitor, by) {
  const saved = visitor.page.waitForEvent('download');
  await visitor.press('save', by);
  const bytes = fs.readFileSync(await (await saved).path());
  const header = bytes.toString('latin1', 0, 400);
  const [nVertices, nFaces] = ['vertex', 'face'].map((element) => Number(new RegExp(`element ${element} (\\d+)`).exec(header)[1]));
  assert.equal(bytes.length, header.indexOf('end_header\n') + 'end_header\n'.length + 24 * nVertices + 13 * nFaces);
  const {status, level, direction} = await visitor.look();
  assert.match(status, /^Saved .*\.ply/);
  if (direction === 0) assert.equal(nFaces, nFacesOf(level));
}

/** Writes a number into an input and leaves it. */
async function write(visitor, name, text) {
  await visitor.page.fill(`#${name}`, text);
  await visitor.page.press(`#${name}`, 'Enter');
}

/** The level is the first one with at most as many faces as are asked for; 0 is the last one. */
async function useCount(visitor) {
  const all = await visitor.page.evaluate(() => Array.from(window.whittle.recording.facesAfter));
  const [first, last] = [all[0], all.at(-1)];
  for (const n of [first, Math.round((first + 3 * last) / 4), 0]) {
    await write(visitor, 'count', String(n));
    const {level} = await standsStill(visitor, 'at a number of faces');
    assert.equal(nFacesOf(level), all.find((faces) => faces <= n) ?? last, `${n} faces are asked for`);
  }
}

/** The largest error of the level is at most what is asked for, and that of a level with a face less is larger. */
async function useLimit(visitor) {
  const levels = await visitor.page.evaluate(() => window.whittle.recording.levels);
  const limit = levels[Math.floor(levels.length / 2)].max * 0.9;
  await write(visitor, 'limit', String(limit));
  const {level, status, labels} = await standsStill(visitor, 'at a largest error');
  const error = (n) => visitor.page.evaluate((faces) => window.whittle.recording.errorAt(faces).max, n);
  assert.ok(await error(nFacesOf(level)) <= limit * (1 + 1e-9), `${level} is farther away than ${limit}`);
  const {next} = await visitor.page.evaluate(() => {
    const {facesAfter, nContractions} = window.whittle.recording;
    return {next: facesAfter.subarray(nContractions).find((faces) => faces < facesAfter[nContractions])};
  });
  if (next !== undefined) assert.ok(await error(next) > limit * (1 - 1e-9), `${next} faces would keep within ${limit}`);
  assert.match(status, /keep within/);
  assert.match(labels, /largest [\d.e-]+ model units/);
}

/** Brings the line between before and after to the middle. */
const centreSplit = (visitor) => visitor.page.evaluate(() => {
  const split = document.getElementById('split');
  split.value = 500;
  split.dispatchEvent(new Event('input'));
});

/** It goes where it is dragged. */
async function useSplit(visitor, by) {
  await centreSplit(visitor);
  const before = await visitor.look();
  if (by === 'keys') {
    await visitor.focus('split');
    for (let i = 0; i < 30; ++i) await visitor.page.keyboard.press('ArrowLeft');
  } else {
    const from = await visitor.point('split', 0.5, 0.5);
    const to = [from[0] - 60, from[1]];
    await (by === 'touch' ? visitor.touch([[from, to]]) : visitor.drag(from, to));
  }
  const after = await visitor.look();
  differ(before, after, 'split');
  differ(before, after, 'picture');
  await centreSplit(visitor);
}

/** What is wider than the window can be scrolled by keys. */
async function useScroller(visitor, name) {
  await visitor.page.evaluate((tag) => document.querySelector(`${tag}[tabindex="0"]`).focus(), name);
  assert.equal(await visitor.page.evaluate(() => document.activeElement.tabIndex), 0);
}

async function useSummary(visitor, by) {
  const isOpen = async () => (await visitor.look()).isOpen;
  const before = await isOpen();
  for (const expected of [!before, before]) {
    await visitor.press('summary', by);
    assert.equal(await isOpen(), expected);
  }
}

/** The slider goes where it is clicked or dragged, and the page stands still there. */
async function useSlider(visitor, by) {
  const goes = async (place, off) => {
    const after = await standsStill(visitor, 'at the slider');
    assert.ok(Math.abs(after.place - place) <= off, `it goes to ${after.place}, not ${place}`);
    return after;
  };
  if (by === 'keys') {
    await visitor.focus('slider');
    for (const [key, place] of [['Home', 0], ['End', 1]]) {
      await visitor.page.keyboard.press(key);
      await goes(place, 0);
    }
    const end = await visitor.look();
    for (let i = 0; i < 5; ++i) await visitor.page.keyboard.press('ArrowLeft');
    assert.ok((await visitor.look()).place < end.place, 'arrow keys move the slider');
    return;
  }
  const seen = [];
  for (const place of [0.25, 0.75]) {
    await visitor.click(await visitor.point('slider', place, 0.5), by);
    seen.push(await goes(place, 0.06));
  }
  differ(...seen, 'level');
  if (seen[0].isRecordingShown) differ(...seen, 'picture');
  if (by === 'mouse') {
    await visitor.drag(await visitor.point('slider', seen[1].place, 0.5), await visitor.point('slider', 0.5, 0.5));
    await goes(0.5, 0.06);
  }
}

/** Turns, moves and zooms, and asks what is where. */
async function useCanvas(visitor, by) {
  const {page} = visitor;
  const share = await page.evaluate(() => {
    const {view} = window.whittle;
    const {width, height} = view.boxes()[0];
    return {x: width / view.width, y: height / view.height};
  });
  const at = (x, y) => visitor.point('canvas', x * share.x, y * share.y);
  const [middle, aside] = [await at(0.4, 0.35), await at(0.65, 0.6)];
  const press = async (...pressed) => {
    await page.focus('#canvas');
    for (const key of pressed) await page.keyboard.press(key);
  };
  const ways = {
    mouse: {'a drag': () => visitor.drag(middle, aside), 'the right button': () => visitor.drag(middle, aside, 'right'),
      'the wheel': () => page.mouse.move(...middle).then(() => page.mouse.wheel(0, 240))},
    touch: {'a finger': () => visitor.touch([[middle, aside]]),
      'two fingers': () => visitor.touch([[middle, middle], [aside, [aside[0] + 40, aside[1] + 20]]])},
    keys: {'an arrow key': () => press('ArrowRight'), 'an arrow key up': () => press('ArrowUp'), 'Shift and an arrow key': () => press('Shift+ArrowLeft'),
      '+': () => press('+'), '-': () => press('-', '-')},
  };
  for (const [what, act] of Object.entries(ways[by])) {
    await trying(what, async () => {
      const before = await visitor.look();
      await act();
      differ(before, await visitor.look(), 'picture');
    });
  }
  await visitor.press('fit', by);
  if (by === 'touch') await scrollsByFingers(visitor, await at(0.4, 0.35)); // the window may have scrolled to the button
  await asksWhatIsThere(visitor, by, at);
}

/** Two fingers that go up together scroll the page, and leave the picture as it is. */
async function scrollsByFingers(visitor, [x, y]) {
  const before = await visitor.look();
  await visitor.touch([-20, 20].map((aside) => [[x + aside, y], [x + aside, y - 60]]));
  const after = await visitor.look();
  assert.ok(after.scrolled > before.scrolled, 'two fingers scroll the page');
  stays(before, after, 'picture');
  await visitor.page.evaluate(() => window.scrollTo(0, 0));
}

/** A point of the surface, as shares of the first pane, or null. */
const surfacePoint = (visitor) => visitor.page.evaluate(() => {
  const app = window.whittle;
  app.view.canvas.scrollIntoView({block: 'nearest', behavior: 'instant'});
  const {left, top, width, height} = app.view.canvas.getBoundingClientRect();
  const faces = app.modelsOfPanes().map((model) => model.faces);
  const box = app.view.boxes()[0];
  const n = 50;
  for (let i = 0; i < n * n; ++i) {
    const [x, y] = [(i % n + 0.5) / n, (Math.floor(i / n) + 0.5) / n];
    const [clientX, clientY] = [left + x * width * box.width / app.view.width, top + y * height * box.height / app.view.height];
    if (document.elementFromPoint(clientX, clientY) === app.view.canvas && app.view.pick({clientX, clientY}, faces).hit) return [x, y];
  }
  return null;
});

async function asksWhatIsThere(visitor, by, at) {
  const says = (pattern, what) => visitor.wait(([source]) => new RegExp(source).test(document.getElementById('status').textContent), [pattern], what);
  if (by === 'keys') {
    await visitor.page.focus('#canvas');
    await visitor.page.keyboard.press('Enter');
    return says('\\(.*,.*,.*\\)|nothing', 'Enter says what is in the middle');
  }
  const there = await surfacePoint(visitor);
  await visitor.click(await at(...there), by);
  await says('\\(.*,.*,.*\\)', 'a click says what is there');
  const {status, spot} = await visitor.look();
  assert.equal(spot, status, 'it is told at the spot');
  await visitor.click(await at(0.02, 0.03), by);
  await says('^$', 'a click beside it says nothing');
  const before = await visitor.look();
  for (let i = 0; i < 2; ++i) await visitor.click(await at(...there), by);
  differ(before, await visitor.look(), 'picture'); // a double click goes there
}

/** \return the kind of control, for what this test does with it */
function useOf(name) {
  if (lists[name]) return useList;
  if (boxes[name]) return useBox;
  if (buttons[name]) return useButton;
  const others = {slider: (visitor, _, by) => useSlider(visitor, by), save: (visitor, _, by) => useSave(visitor, by), count: useCount, limit: useLimit,
    split: (visitor, _, by) => useSplit(visitor, by), div: useScroller, figure: useScroller, pre: useScroller, canvas: (visitor, _, by) => useCanvas(visitor, by),
    summary: (visitor, _, by) => useSummary(visitor, by)};
  assert.ok(others[name], `this test doesn't know the control "${name}"`);
  return others[name];
}

/** Uses each control of a part of the page, and adds its name to `used`. \param reach brings the page into the state */
async function usesEach(visitor, {ofPlayer, reach, by, about, used}) {
  await reach();
  for (const name of await visitor.controls(ofPlayer)) {
    await reach();
    if (!await visitor.isUsable(name)) continue; // not in this state any more
    await trying(`${name} by ${by}`, () => useOf(name)(visitor, name, by, about));
    used.add(name);
  }
}

/** The player's controls. \param states of the player: places, and directions in which it plays or 0 */
async function usesThePlayer(page, {by, about, states, used}) {
  const visitor = new Visitor(page);
  for (const [place, direction] of states) {
    await trying(`at ${place}, direction ${direction}`, () =>
      usesEach(visitor, {ofPlayer: true, reach: () => visitor.reach(place, direction), by, about, used}));
  }
  for (const [speed, name] of [[64, 'faster'], [1 / 64, 'slower']]) {
    await visitor.reach(0.5, 0, speed);
    assert.ok(!await visitor.isUsable(name), `${name} has no more to give`);
  }
}

/** The other controls, in states that have each layout and each colouring. */
async function usesTheView(page, {by, about, used}) {
  const visitor = new Visitor(page);
  const layouts = await visitor.isUsable('layout') ? await visitor.options('layout') : [null];
  const colours = await visitor.options('colour');
  for (let i = 0; i < Math.max(layouts.length, colours.length); ++i) {
    const [layout, colour] = [layouts[i % layouts.length], colours[i % colours.length]];
    const reach = () => visitor.prepare({...layout && {layout}, colour});
    await trying(`${layout}, ${colour}`, () => usesEach(visitor, {ofPlayer: false, reach, by, about, used}));
  }
}

/** Each key of the list does what its control does, whatever has the focus but a list. */
async function usesTheKeys(page, {about}) {
  const visitor = new Visitor(page);
  const listed = await page.$$eval('#key-list dt', (all) => all.flatMap((term) => term.textContent.split(' ')));
  for (const key of listed) {
    assert.ok(keys[key], `this test doesn't know the key "${key}"`);
    await trying(`the key ${key}`, () => usesTheKey(visitor, key, about));
  }
  for (const name of await visitor.controls()) {
    if (['canvas', 'summary', 'slider', 'div', 'figure', 'pre'].includes(name)) continue; // Tab and the keys of browsers
    assert.ok(listed.some((key) => keys[key] === name), `no key is listed for ${name}`);
  }
}

async function usesTheKey(visitor, key, about) {
  const {page} = visitor;
  const name = typeof keys[key] === 'string' ? keys[key] : null;
  for (const focused of ['body', 'canvas', 'edges']) {
    if (key === 'Esc' && focused !== 'edges') continue;
    const layout = await visitor.isUsable('layout') && {layout: {ghost: 'over', split: 'split'}[name] ?? (key === '1' ? 'result' : 'beside')};
    const colour = name === 'top' && (await visitor.options('colour')).includes('error') && {colour: 'error'};
    await visitor.prepare({...layout, ...colour});
    if (await visitor.isUsable('play')) await visitor.reach(0.5037, 0);
    await page.evaluate((isTurned) => {
      if (isTurned) window.whittle.view.rotate(0.3, 0.2);
      window.whittle.forgetWhatWasDescribed();
    }, name === 'fit');
    if (name && !await visitor.isUsable(name) || focused === 'edges' && ['Space'].includes(key)) continue;
    if (lists[name] && (await visitor.options(name)).length < 2) continue;
    await page.evaluate((id) => (document.getElementById(id) ?? document.activeElement)[id === 'body' ? 'blur' : 'focus'](), focused);
    const before = await visitor.look();
    const saved = name === 'save' && page.waitForEvent('download');
    await page.keyboard.press({Arrows: 'ArrowRight', '−': '-', Esc: 'Escape'}[key] ?? key);
    if (key === 'Enter') await visitor.wait(() => document.getElementById('status').textContent !== '', [], 'what is in the middle');
    if (saved) await saved;
    else if (buttons[name]) await buttons[name](visitor, before);
    else (lists[name] ?? boxes[name] ?? inputs[name] ?? keys[key])(before, await visitor.look(), about);
  }
}

module.exports = {usesThePlayer, usesTheView, usesTheKeys, known: [...Object.keys({...lists, ...boxes, ...buttons, ...inputs}), 'slider', 'canvas', 'summary', 'save', 'div', 'figure', 'pre']};
