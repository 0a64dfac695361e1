// Opens pages that run.sh has written.
'use strict';
const assert = require('assert/strict');
const path = require('path');

/** \return `close`, and `withPage`, which opens a page, lets `use` try it, and checks that it was silent */
async function openBrowser(nodeModules, chromium, folder) {
  const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));
  const browser = await driver.launch({executablePath: chromium,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});

  async function withPage(name, use, {hash = '', width = 1200, height = 900, colorScheme = 'light', hasTouch = false} = {}) {
    const context = await browser.newContext({viewport: {width, height}, colorScheme, hasTouch});
    const page = await context.newPage();
    const messages = [];
    page.on('console', (message) => messages.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => messages.push(`error: ${error.message}`));
    page.on('dialog', (dialog) => messages.push(`dialog: ${dialog.message()}`) && dialog.dismiss());
    const requests = [];
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(`file://${path.resolve(folder, name).split('/').map(encodeURIComponent).join('/')}${hash}`);
    await page.waitForFunction(() => document.documentElement.dataset.ready);
    await use(page);
    assert.deepEqual(messages, [], `${name} is silent`);
    assert.equal(requests.length, 1, `${name} asks for nothing: ${requests}`);
    await context.close();
  }
  return {withPage, close: () => browser.close()};
}

module.exports = {openBrowser};
