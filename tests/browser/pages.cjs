// Opens pages that run.sh has written.
'use strict';
const assert = require('assert/strict');
const fs = require('fs');
const path = require('path');

/** \return `browser`, `close`, and `withPage`, which opens a page, lets `use` try it, and checks that it was silent */
async function openBrowser(nodeModules, chromium, folder) {
  const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));
  const browser = await driver.launch({executablePath: chromium,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});

  const opened = new Map(); // windows, with touch and without: what starts a page anew takes less than what starts a window

  async function pageIn(hasTouch) {
    if (!opened.has(hasTouch)) opened.set(hasTouch, await (await browser.newContext({hasTouch})).newPage());
    return opened.get(hasTouch);
  }

  async function withPage(name, use, {hash = '', width = 600, height = 500, colorScheme = 'light', hasTouch = false} = {}) {
    const page = await pageIn(hasTouch);
    await page.setViewportSize({width, height});
    await page.emulateMedia({colorScheme});
    const messages = [];
    const isOfTest = (message) => message.text().includes('GPU stall due to ReadPixels'); // which looks at pictures
    page.on('console', (message) => isOfTest(message) || messages.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => messages.push(`error: ${error.message}`));
    page.on('dialog', (dialog) => messages.push(`dialog: ${dialog.message()}`) && dialog.dismiss());
    const requests = [];
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(`file://${path.resolve(folder, name).split('/').map(encodeURIComponent).join('/')}${hash}`);
    await page.waitForFunction(() => document.documentElement.dataset.ready);
    await use(page);
    assert.deepEqual(messages, [], `${name} is silent`);
    assert.equal(requests.length, 1, `${name} asks for nothing: ${requests}`);
    page.removeAllListeners();
    await page.goto('about:blank'); // the same page with another hash would not begin anew
  }
  return {browser, withPage, close: () => browser.close()};
}

/** What axe finds on a page. */
async function axeViolations(nodeModules, page) {
  await page.evaluate(fs.readFileSync(path.join(nodeModules, 'axe-core', 'axe.min.js'), 'utf8'));
  const {violations, passes} = await page.evaluate(() => window.axe.run());
  assert.ok(passes.length > 10, 'axe has looked at the page');
  return violations;
}

module.exports = {axeViolations, openBrowser};
