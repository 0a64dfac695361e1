// simplify.cjs NODE_MODULES CHROMIUM PAGE.html MESH WHITTLE FOLDER: opens the page that simplifies from its file, gives it
// a mesh, asks for results, saves them, and compares what is saved with what the program writes.
'use strict';
const assert = require('assert/strict');
const {execFileSync} = require('child_process');
const fs = require('fs');
const path = require('path');
const {axeViolations, openBrowser} = require('./pages.cjs');

const [nodeModules, chromium, file, mesh, whittle, folder] = process.argv.slice(2);

const patience = 60000; // milliseconds, on a busy machine
const [laptop, phone] = [{width: 1366, height: 768}, {width: 400, height: 800}];
const nFaces = 5120;

/** What the program writes. */
function written(format, options) {
  const out = path.join(folder, `expected.${format}`);
  execFileSync(whittle, ['simplify', mesh, '-o', out, '--quiet', ...options]);
  return fs.readFileSync(out);
}

/** Somebody who uses the page. */
class User {
  constructor(page) {
    this.page = page;
  }

  text(id) {
    return this.page.$eval(`#${id}`, (element) => element.textContent);
  }

  async number(id) {
    return Number(await this.page.inputValue(`#${id}`));
  }

  until(condition, about, what) {
    return this.page.waitForFunction(condition, about, {timeout: patience}).catch(() => { throw new Error(`not seen: ${what}`); });
  }

  /** Until nothing goes on that could be cancelled. */
  rest() {
    return this.until(() => document.getElementById('work').hidden, null, 'the end of the work');
  }

  async choose(...files) {
    await this.page.setInputFiles('#files', files);
    await this.rest();
  }

  /** Until the error curve is complete. */
  async measured() {
    await this.until(() => document.querySelector('#curve polyline.max') && document.getElementById('measured').textContent === '', null,
      'the error curve');
  }

  async ask(kind, amount) {
    await this.page.selectOption('#kind', kind);
    await this.page.fill('#amount', String(amount));
    await this.page.press('#amount', 'Enter');
  }

  async press(id) {
    await this.page.click(`#${id}`);
    await this.rest();
    assert.equal(await this.text('alert'), '', `${id} works`);
  }

  /** Saves. \return the bytes of the file */
  async save() {
    const [download] = await Promise.all([this.page.waitForEvent('download', {timeout: patience}), this.page.click('#save-result')]);
    await this.rest();
    return fs.readFileSync(await download.path());
  }

  /** The faces of what the picture shows on its right, and of what its label says. */
  async shown() {
    const label = await this.text('right-label');
    const n = await this.page.evaluate(() => window.whittle.result.surface.nFaces);
    assert.equal(Number(/([\d,]+) faces/.exec(label)[1].replaceAll(',', '')), n);
    return n;
  }

  /** The level of so many faces is shown, or the next one with fewer. */
  async shows(n) {
    const faces = await this.shown();
    assert.ok(faces <= n && faces >= n - 8, `${faces} faces are shown, not ${n}`);
  }
}

/** Bytes are the same; of long ones the first difference is told. */
function isSame(bytes, expected, what) {
  const at = bytes.findIndex((byte, i) => byte !== expected[i]);
  assert.ok(bytes.length === expected.length && at < 0, `${what}: ${bytes.length} bytes, expected ${expected.length}, differ from byte ${at} on`);
}

/** Does something in the page that is no task of its own. */
async function aside(page, act) {
  const begin = await page.evaluate(() => performance.now());
  const done = await act();
  await page.evaluate((from) => window.others.push([from, performance.now()]), begin);
  return done;
}

/** Tells how long the page has stood still at most since it was asked for the last time. It depends on the machine. */
async function tellLongestTask(page, what) {
  const most = await page.evaluate(() => {
    const isOwn = ({startTime, duration}) => !window.others.some(([begin, end]) => startTime < end && startTime + duration > begin);
    return Math.max(0, ...window.tasks.splice(0).filter(isOwn).map(({duration}) => duration));
  });
  console.log(`${what}: the longest task took ${most} ms`);
}

async function isAccessible(page, what) {
  const violations = await aside(page, () => axeViolations(nodeModules, page));
  assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes.map(({html}) => html).slice(0, 3)}`), [], what);
}

/** Every control that can be used says what it does. */
async function namesItsControls(page) {
  const untold = await page.$$eval('button, input, select', (all) => all
    .filter((e) => e.offsetParent !== null && !e.closest('[title]')).map(({id}) => id));
  assert.deepEqual(untold, [], 'controls without a tooltip');
}

/** All controls are in the window without scrolling. */
async function fitsTheWindow(page, {width, height}) {
  const outside = await page.$$eval('button, input, select, canvas, #curve', (all, [right, bottom]) => all
    .filter((e) => e.offsetParent !== null || e.id === 'curve')
    .map((e) => ({id: e.id, box: e.getBoundingClientRect()}))
    .filter(({box}) => box.left < 0 || box.top < 0 || box.right > right || box.bottom > bottom).map(({id}) => id), [width, height]);
  assert.deepEqual(outside, [], 'controls out of the window');
}

async function welcomes(page) {
  assert.match(await page.textContent('#welcome'), /Nothing leaves this machine/);
  await isAccessible(page, 'before there is a mesh');
  await namesItsControls(page);
}

/** The slider, the number and the curve agree, and the picture follows. */
async function choosesATarget(user) {
  const {page} = user;
  await page.focus('#range');
  await page.keyboard.press('End');
  const all = await user.number('amount');
  await user.shows(all);
  await page.keyboard.press('Home');
  const few = await user.number('amount');
  assert.ok(few < all / 50, `down to ${few} faces`);
  await user.shows(few);
  const {x, y, width, height} = await page.locator('#range').boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
  const middle = await user.number('amount');
  assert.ok(Math.abs(Math.log(middle / Math.sqrt(few * all))) < 0.1, `${middle} faces in the middle of the slider`);
  await user.shows(middle);
  await page.keyboard.press('ArrowRight');
  assert.ok(await user.number('amount') >= middle);
  await user.ask('faces', nFaces);
  await user.shows(nFaces);
}

async function drawsTheCurve(user) {
  const {page} = user;
  const counts = await page.$$eval('#curve polyline', (lines) => lines.map((line) => line.points.length));
  assert.ok(counts.length === 2 && counts.every((n) => n >= 5), `points of the curve: ${counts}`);
  const {x, y, width, height} = await page.locator('#curve').boundingBox();
  await page.mouse.click(x + 0.8 * width, y + height / 2);
  const many = await user.number('amount');
  await user.shows(many);
  await page.mouse.move(x + 0.8 * width, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + 0.4 * width, y + height / 2, {steps: 5});
  await page.mouse.up();
  const few = await user.number('amount');
  assert.ok(few < many / 2, `${few} faces are left of ${many}`);
  await page.focus('#curve');
  await page.keyboard.press('ArrowRight');
  assert.ok(await user.number('amount') > few, 'the arrow keys move the mark');
  await user.shows(await user.number('amount'));
}

/** What is saved is what the program writes. */
async function savesWhatTheProgramWrites(user) {
  const {page} = user;
  await user.ask('faces', nFaces);
  await user.press('simplify');
  assert.equal(await user.shown(), nFaces);
  assert.match(await user.text('made'), /5,120.*Largest[\d.e-]+ model units/);
  isSame(await user.save(), written('ply', ['--faces', nFaces]), 'PLY');
  for (const format of ['stl', 'obj', 'off']) {
    await page.selectOption('#format', format);
    await user.rest();
    isSame(await user.save(), written(format, ['--faces', nFaces]), format);
  }
  await page.selectOption('#format', 'ply');
  await page.selectOption('#effort', 'fast');
  assert.match(await user.text('made'), /has changed since/);
  isSame(await user.save(), written('ply', ['--faces', nFaces, '--effort', 'fast']), 'fast effort'); // simplified before
}

/** The result has no colours of errors; the level of the run with as many faces has, up to its largest error. */
async function goesToTheWorstPlace(user) {
  await user.page.click('#worst');
  await user.until(() => /^Largest distance/.test(document.getElementById('spot').textContent), null, 'the worst place');
  await user.shows(nFaces);
  const [, largest] = /largest ([\d.e-]+)/.exec(await user.text('right-label'));
  assert.equal(await user.page.textContent('#legend .ticks span:last-child'), largest);
}

async function keepsWithinAnError(user) {
  const {page} = user;
  await page.selectOption('#kind', 'error');
  const limit = await user.number('amount');
  await user.ask('error', limit * 2);
  const label = await user.text('right-label');
  assert.ok(Number(/largest ([\d.e-]+) model units/.exec(label)[1]) <= limit * 2 * 1.005, label);
  await page.check('#prove');
  await user.press('simplify');
  assert.match(await user.text('made'), /Proven/);
  await page.uncheck('#prove');
}

/** What OBJ takes a face isn't known before: the first result is too large. */
async function keepsWithinASize(user) {
  await user.page.selectOption('#format', 'obj');
  await user.ask('size', 150);
  await user.press('simplify');
  const {length} = await user.save();
  assert.ok(length <= 150000 && length > 100000, `${length} bytes`);
  await user.page.selectOption('#format', 'ply');
  await user.rest();
}

/** A run that is cancelled ends, and leaves the page as it was. */
async function cancels(user) {
  const {page} = user;
  const [worker] = page.workers();
  await page.selectOption('#kind', 'error');
  await page.check('#prove');
  await page.selectOption('#effort', 'best'); // takes seconds
  await page.click('#simplify');
  const ended = new Promise((end, fail) => {
    worker.on('close', end);
    setTimeout(() => fail(new Error('the run goes on')), patience).unref();
  });
  await Promise.all([ended, page.click('#cancel')]);
  await user.rest();
  assert.equal(await user.text('alert'), '');
  await user.ask('faces', nFaces);
  await page.selectOption('#effort', 'normal');
  isSame(await user.save(), written('ply', ['--faces', nFaces]), 'after it was cancelled');
}

async function bearsBrokenFiles(user) {
  const broken = path.join(folder, 'broken.ply');
  const text = path.join(folder, 'readme.txt');
  fs.writeFileSync(broken, 'broken\n');
  fs.writeFileSync(text, 'no mesh\n');
  for (const one of [broken, text]) {
    const before = await user.text('title');
    await user.choose(one);
    await user.until(() => document.getElementById('alert').textContent !== '', null, `what is wrong with ${one}`);
    assert.equal(await user.text('title'), before);
    await isAccessible(user.page, 'with an alert');
    await user.press('simplify');
  }
}

/** Two meshes are dropped together, one of them compressed; a list has both. */
async function takesDrops(user) {
  const {page} = user;
  const base64 = fs.readFileSync(mesh).toString('base64');
  const [first, other] = [path.basename(mesh), `other_${path.basename(mesh)}.gz`];
  const isTaken = await aside(page, () => page.evaluate(async ([text, ...names]) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const packed = await new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer();
    const dataTransfer = new DataTransfer();
    for (const [i, part] of [bytes, packed].entries()) dataTransfer.items.add(new File([part], names[i]));
    return ['dragover', 'drop'].every((type) =>
      !document.getElementById('stage').dispatchEvent(new DragEvent(type, {dataTransfer, bubbles: true, cancelable: true})));
  }, [base64, first, other]));
  assert.ok(isTaken, 'the browser would show what is dropped by itself');
  await user.until(() => document.getElementById('mesh').options.length === 2, null, 'the list of meshes');
  await user.rest();
  await page.selectOption('#mesh', other);
  await user.until(() => document.getElementById('title').textContent.startsWith('other_'), null, 'the other mesh');
  await user.rest();
  assert.equal(await page.inputValue('#mesh'), other);
  await user.measured();
}

async function uses(page) {
  const user = new User(page);
  await welcomes(page);
  await user.choose(mesh);
  assert.equal(await user.text('title'), path.basename(mesh));
  await user.measured();
  await tellLongestTask(page, 'opens');
  await fitsTheWindow(page, laptop);
  await namesItsControls(page);
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({colorScheme});
    await isAccessible(page, colorScheme);
  }
  const all = [choosesATarget, drawsTheCurve, keepsWithinASize, savesWhatTheProgramWrites, goesToTheWorstPlace, keepsWithinAnError,
    cancels, bearsBrokenFiles, takesDrops];
  for (const does of all) {
    await does(user).catch((error) => { throw new Error(`${does.name}: ${error.message}`, {cause: error}); });
    await tellLongestTask(page, does.name);
  }
  await page.setViewportSize(phone);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'a phone scrolls aside');
  await isAccessible(page, 'on a phone');
  await user.press('simplify');
}

/** It makes its own mesh for those who have none. */
async function showsAnExample(page) {
  const user = new User(page);
  await page.click('#example');
  await user.until(() => document.documentElement.dataset.ready, null, 'the example');
  await user.rest();
  await user.press('simplify');
}

/** Opens the page, and checks that it was silent and never stood still. */
async function withPage(browser, use) {
  const page = await browser.newPage({viewport: laptop, acceptDownloads: true});
  const messages = [];
  page.on('console', (message) => messages.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => messages.push(`error: ${error.message}`));
  page.on('request', (request) => { if (!request.url().startsWith('blob:')) messages.push(`request: ${request.url()}`); });
  const url = `file://${path.resolve(file)}`;
  await page.addInitScript(() => {
    [window.tasks, window.others] = [[], []];
    new PerformanceObserver((list) => window.tasks.push(...list.getEntries())).observe({type: 'longtask', buffered: true});
  });
  await page.goto(url);
  await use(page);
  assert.deepEqual(messages, [`request: ${url}`], 'it is silent');
  await tellLongestTask(page, use.name);
  await page.close();
}

async function main() {
  fs.mkdirSync(folder, {recursive: true});
  const {browser, close} = await openBrowser(nodeModules, chromium, folder);
  try {
    await withPage(browser, uses);
    await withPage(browser, showsAnExample);
  } finally {
    await close();
  }
  console.log('the page simplifies');
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
