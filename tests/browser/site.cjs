// site.cjs NODE_MODULES CHROMIUM SITE: tries the site of the target docs, from files and from a server: its search, and that
// narrow and dark windows show it well. Fails if a page prints to the console.
'use strict';
const assert = require('assert/strict');
const fs = require('fs');
const http = require('http');
const path = require('path');

const [nodeModules, chromium, folder] = process.argv.slice(2);
const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));
const types = {'.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.png': 'image/png', '.svg': 'image/svg+xml'};

/** A server of the folder; it knows no address but files'. */
function serve() {
  const server = http.createServer((request, response) => {
    const name = new URL(request.url, 'http://site').pathname;
    const file = path.join(path.resolve(folder), path.normalize(name));
    if (!fs.existsSync(file)) return response.writeHead(name === '/favicon.ico' ? 204 : 404).end();
    response.writeHead(200, {'Content-Type': types[path.extname(file)] || 'text/plain'});
    return fs.createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

const results = (page) => page.$$eval('#site-results a b', (found) => found.map((element) => element.textContent));

async function search(page, query) {
  await page.fill('#site-search input', query);
  await page.waitForSelector('#site-results > *');
  return results(page);
}

async function findsTextAndNames(page, base) {
  await page.goto(`${base}/user_simplify.html`);
  assert.equal((await search(page, 'DecimateTarget'))[0], 'whittle::DecimateTarget');
  assert.equal((await search(page, 'polish.hh'))[0], 'polish.hh');
  assert.ok((await search(page, 'Blender MeshFix')).includes("Using whittle › What Whittle doesn't do"));
  assert.deepEqual(await search(page, 'nosuchword'), []);
  assert.match(await page.textContent('#site-results'), /Nothing found/);
  await search(page, 'Fill Holes');
  await page.keyboard.press('Enter');
  await page.waitForURL(/user\.html#what-whittle-doesnt-do$/);
  assert.match(await page.textContent('#what-whittle-doesnt-do'), /What Whittle doesn't do/);
  await search(page, '--tolerance-map');
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#site-results'));
}

/** Tables and code scroll by themselves: no page is wider than the window. */
async function fits(page, base, width) {
  for (const name of ['index', 'user', 'user_simplify', 'user_formats_ply', 'dev_performance', 'dev_architecture', 'reference',
    'bibliography', 'annotated', 'namespacewhittle', 'classwhittle_1_1DecimateTarget', 'structwhittle_1_1IndexedMesh']) {
    await page.goto(`${base}/${name}.html`);
    const content = await page.$eval('#doc-content', (element) => [element.scrollWidth, element.clientWidth]);
    assert.equal(content[0], content[1], `${name} fits ${width} pixels`);
    assert.equal(await page.isVisible('#nav-tree'), width > 767, `${name} has its tree where there is room`);
    assert.equal(await page.isVisible('.main-menu-btn'), width < 768, `${name} has its menu where there is none`);
  }
}

/** Where the tree has no room, the menu has the pages. */
async function hasAMenu(page, base) {
  await page.goto(`${base}/user_simplify.html`);
  await page.click('.main-menu-btn');
  await page.click('#main-menu >> text=For developers');
  await page.waitForURL(/dev\.html$/);
}

/** How light the middle of the page's left edge is, from 0 to 255. */
async function lightness(page, base) {
  await page.goto(`${base}/user_simplify.html`);
  const picture = (await page.screenshot({clip: {x: 300, y: 450, width: 1, height: 1}})).toString('base64');
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement('canvas').getContext('2d');
    canvas.drawImage(image, 0, 0);
    return canvas.getImageData(0, 0, 1, 1).data[1];
  }, picture);
}

async function main() {
  const browser = await driver.launch({executablePath: chromium, args: ['--no-sandbox', '--disable-dev-shm-usage']});
  const server = await serve();
  const files = `file://${path.resolve(folder).split('/').map(encodeURIComponent).join('/')}`;
  async function withPage(use, base, {width = 1400, colorScheme = 'light'} = {}) {
    const context = await browser.newContext({viewport: {width, height: 900}, colorScheme});
    const page = await context.newPage();
    const messages = [];
    page.on('console', (message) => messages.push(`${page.url()}: ${message.text()}`));
    page.on('pageerror', (error) => messages.push(`${page.url()}: ${error.message}`));
    const value = await use(page, base, width);
    assert.deepEqual(messages, [], 'the pages are silent');
    await context.close();
    return value;
  }
  await withPage(findsTextAndNames, files);
  await withPage(findsTextAndNames, `http://127.0.0.1:${server.address().port}`);
  await withPage(fits, files, {width: 400});
  await withPage(fits, files);
  await withPage(hasAMenu, files, {width: 400});
  const light = await withPage(lightness, files);
  const dark = await withPage(lightness, files, {colorScheme: 'dark'});
  assert.ok(light > 200 && dark < 60, `light ${light}, dark ${dark}`);
  server.close();
  await browser.close();
  console.log('the site is as it should be');
}

main().catch((error) => {
  console.error(error);
  process.exit(1);
});
