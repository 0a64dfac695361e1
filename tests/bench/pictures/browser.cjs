// Has Chromium draw glTF files: a server for page.html, three.js and the files, and the page of that server.
'use strict';
const fs = require('fs');
const http = require('http');
const path = require('path');

const types = {'.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm'};

const urlOf = (file) => `/file${path.resolve(file).split('/').map(encodeURIComponent).join('/')}`;

/** Where what the page asks for lies; null for anything else. */
function fileOf(url, nodeModules, cache) {
  const name = decodeURIComponent(url.split('?')[0]);
  const [, root, rest] = /^\/(three|file|cache)\/(.*)$/.exec(name) ?? [];
  if (root) return path.join({three: path.join(nodeModules, 'three'), file: '/', cache}[root], rest);
  return ['/page.html', '/page.mjs'].includes(name) ? path.join(__dirname, name) : null;
}

function answer(request, response, file) {
  if (file && request.method === 'PUT') {
    fs.mkdirSync(path.dirname(file), {recursive: true});
    return request.pipe(fs.createWriteStream(file)).on('finish', () => response.end());
  }
  if (!file || !fs.existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, {'Content-Type': types[path.extname(file)] ?? 'application/octet-stream'});
  return fs.createReadStream(file).pipe(response);
}

/** \return `ask`, which calls a function of the page, and `close` */
async function openPage({nodeModules, chromium, cache}) {
  const {chromium: driver} = require(path.join(path.resolve(nodeModules), 'playwright-core'));
  const server = http.createServer((request, response) => answer(request, response, fileOf(request.url, nodeModules, cache)));
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const browser = await driver.launch({executablePath: chromium,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
  const page = await browser.newPage();
  page.on('pageerror', (error) => console.error(`page: ${error.message}`));
  await page.goto(`http://127.0.0.1:${server.address().port}/page.html`);
  await page.waitForFunction(() => document.documentElement.dataset.ready);
  const ask = (name, ...values) => page.evaluate(([called, given]) => window.pictures[called](...given), [name, values]);
  return {ask, close: async () => {
    await browser.close();
    server.close();
  }};
}

module.exports = {openPage, urlOf};
