// live.cjs NODE_MODULES CHROMIUM WHITTLE MESH FOLDER: opens the page of a run in Chromium, turns the mesh, and follows
// the run to its end. A run stands still at a known moment: its result goes to a pipe that nobody reads.
'use strict';
const assert = require('assert/strict');
const {spawn} = require('child_process');
const {copyFileSync, existsSync, readFileSync, renameSync} = require('fs');
const path = require('path');
const {openBrowser} = require('./pages.cjs');

const [nodeModules, chromium, whittle, mesh, folder] = process.argv.slice(2);

const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** A run that has written its last page but the report. */
async function runTo(ratio, page) {
  const options = ['-o', '-', '--format', 'ply', '--face-ratio', ratio, '--live', page, '--quiet'];
  const program = spawn(whittle, ['simplify', mesh, ...options], {stdio: ['ignore', 'pipe', 'inherit']});
  const ended = new Promise((resolve) => program.on('exit', (code) => resolve(code)));
  const last = '"live":{"stage":"measuring and writing"';
  const isThere = () => existsSync(page) && readFileSync(page, 'utf8').includes(last);
  while (!isThere()) await sleep(20);
  return {program, ended};
}

/** The file appears complete, as the program's does. */
function show(from, page) {
  copyFileSync(from, `${page}.new`);
  renameSync(`${page}.new`, page);
}

const camera = (page) => page.evaluate(() => {
  const {view, json} = window.whittle;
  return view.camera.position.toArray().map((x, i) => json.origin[i] + x * json.step * 65535);
});

function isNear(a, b) {
  a.forEach((x, i) => assert(Math.abs(x - b[i]) < 0.01, `camera at ${a}, not at ${b}`));
}

/** Waits until the page that is shown has a property. It is read again meanwhile, which ends what asks it. */
async function until(page, holds) {
  for (;;) {
    try {
      const isReady = () => document.documentElement.dataset.ready && window.whittle;
      await page.waitForFunction(isReady, null, {timeout: 20000});
      if (await page.evaluate(holds)) return;
    } catch (error) {
      if (!/navigation|destroyed|detached/i.test(error.message)) throw error;
    }
    await sleep(20);
  }
}

async function follow(page, requests) {
  const shown = path.resolve(folder, 'live.html');
  const half = path.join(folder, 'half.html');
  const first = await runTo('50%', half);
  show(half, shown);
  first.program.kill('SIGKILL');

  await page.goto(`file://${shown}`);
  await until(page, () => window.whittle.json.live.faces === 25600);
  assert.match(await page.textContent('#live'), /^measuring and writing: 25,600 faces left, target 25600 faces, /);
  await page.evaluate(() => {
    window.whittle.view.rotate(1, 0.3);
    document.getElementById('layout').value = 'result';
    document.getElementById('layout').dispatchEvent(new Event('change'));
    window.isFirst = true;
  });
  const before = await camera(page);
  await until(page, () => !window.isFirst); // it is read again
  isNear(await camera(page), before);

  const second = await runTo('10%', shown);
  await until(page, () => window.whittle.json.live?.faces === 5120);
  isNear(await camera(page), before);
  assert.equal(await page.inputValue('#layout'), 'result');

  second.program.stdout.resume();
  assert.equal(await second.ended, 0);
  await until(page, () => !window.whittle.json.live);
  isNear(await camera(page), before);
  assert.equal(await page.inputValue('#layout'), 'result');
  assert.equal(await page.locator('#live').count(), 0);
  assert(await page.evaluate(() => window.whittle.json.recording), 'the report is there');
  await page.evaluate(() => { window.isReport = true; });
  await sleep(2500); // more than two intervals
  assert(await page.evaluate(() => window.isReport), 'the report is not read again');
  assert.deepEqual([...new Set(requests)], [`file://${shown}`]);
}

/** The page of a run that failed stays as it is. */
async function seeFailure(page) {
  const failed = path.resolve(folder, 'failed.html');
  const {program, ended} = await runTo('50%', failed);
  program.kill('SIGTERM');
  program.stdout.resume();
  assert.equal(await ended, 143);
  await page.goto(`file://${failed}`);
  await until(page, () => window.whittle.json.live.problem === 'interrupted');
  assert.match(await page.textContent('#live'), /^The run has ended without a result: interrupted\. /);
  await page.evaluate(() => { window.isFirst = true; });
  await sleep(2500);
  assert(await page.evaluate(() => window.isFirst), 'it is not read again');
}

async function main() {
  const {browser, close} = await openBrowser(nodeModules, chromium, folder);
  try {
    const page = await browser.newPage({viewport: {width: 500, height: 400}});
    const messages = [];
    page.on('console', (message) => messages.push(message.text()));
    page.on('pageerror', (error) => messages.push(error.message));
    const requests = [];
    page.on('request', (request) => requests.push(request.url()));
    await follow(page, requests);
    await seeFailure(page);
    assert.deepEqual(messages, []);
  } finally {
    await close();
  }
}

main().catch((error) => {
  console.error(error);
  process.exitCode = 1;
});
