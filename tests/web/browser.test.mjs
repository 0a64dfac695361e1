// The package in Chromium: bytes as in Node.js, workers, cancelling, and the example for three.js, drawn.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {createReadStream, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {test} from 'node:test';
import {folder, npm, terrain, whittle, without} from './package.mjs';

const chromium = ['chromium', 'chromium-browser', 'google-chrome']
  .map((name) => path.join('/usr/bin', name))
  .find(existsSync);
const skip =
  without('playwright-core') || without('three') || without('esbuild') || (!chromium && 'no Chromium is there');
const types = {'.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm'};

/** A server of some folders: the first that has the file. */
function serve(folders) {
  const server = createServer((request, response) => {
    const {pathname} = new URL(request.url, 'http://site');
    const file = folders.map((root) => path.join(root, path.normalize(pathname))).find(existsSync);
    if (!file || pathname === '/') return response.writeHead(pathname === '/favicon.ico' ? 204 : 404).end();
    response.writeHead(200, {'Content-Type': types[path.extname(file)] ?? 'text/plain'});
    return createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

/** Calls `use` with a page of a browser, which may print nothing. */
async function inBrowser(folders, use) {
  const {chromium: driver} = createRequire(import.meta.url)(path.join(npm, 'playwright-core'));
  const server = await serve(folders);
  const browser = await driver.launch({
    executablePath: chromium,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  try {
    const page = await browser.newPage();
    const said = [];
    page.on('pageerror', (error) => said.push(error.message));
    page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
    await use(page, `http://127.0.0.1:${server.address().port}`);
    assert.deepEqual(said, []);
  } finally {
    await browser.close();
    server.close();
  }
}

test('gives the bytes of Node.js, here and in a worker, and can be cancelled', {skip}, async () => {
  const scratch = mkdtempSync(path.join(tmpdir(), 'whittle-'));
  writeFileSync(path.join(scratch, 'empty.html'), '<!doctype html><title>empty</title>');
  const mesh = terrain(50);
  const options = {faceRatio: 0.1};
  const here = whittle.simplify(mesh, options);
  await inBrowser([folder, scratch], async (page, site) => {
    await page.goto(`${site}/empty.html`);
    const there = await page.evaluate(
      async ([positions, indices, texcoords, options]) => {
        const {ready, simplify, simplifyInWorker} = await import('/index.js');
        await ready;
        const mesh = {positions: Float32Array.from(positions), indices, texcoords: Float32Array.from(texcoords)};
        const plain = ({positions, indices, texcoords}) =>
          [positions, indices, texcoords].map((all) => Array.from(all));
        const stages = new Set();
        const small = plain(simplify(mesh, options));
        const inWorker = plain(await simplifyInWorker(mesh, options, {onProgress: (stage) => stages.add(stage)}));
        const controller = new AbortController();
        const running = simplifyInWorker(mesh, options, {
          signal: controller.signal,
          onProgress: () => controller.abort(),
        });
        const cancelled = await running.catch((error) => error.name);
        const wrong = await simplifyInWorker(mesh, {faceRatio: 3}).catch((error) => error.message);
        return {small, inWorker, stages: [...stages], cancelled, wrong};
      },
      [Array.from(mesh.positions), Array.from(mesh.indices), Array.from(mesh.texcoords), options],
    );
    assert.deepEqual(
      there.small,
      [here.positions, here.indices, here.texcoords].map((all) => Array.from(all)),
    );
    assert.deepEqual(there.inWorker, there.small);
    assert.deepEqual(there.stages, ['decimating', 'polishing']);
    assert.equal(there.cancelled, 'AbortError');
    assert.match(there.wrong, /^faceRatio: '3'/);
  });
  rmSync(scratch, {recursive: true});
});

test('the example for three.js draws what the slider asks for', {skip}, async () => {
  const scratch = mkdtempSync(path.join(tmpdir(), 'whittle-'));
  const examples = path.join(process.env.WHITTLE_SOURCE, 'modules/web/examples');
  const bundle = (from, to) =>
    execFileSync(
      path.join(npm, '.bin/esbuild'),
      [
        from,
        '--bundle',
        '--format=esm',
        '--external:node:*',
        `--outfile=${path.join(scratch, to)}`,
        '--log-level=error',
      ],
      {env: {...process.env, NODE_PATH: path.join(folder, '../node_modules')}},
    );
  bundle(path.join(examples, 'three.js'), 'three.bundle.js');
  writeFileSync(path.join(scratch, 'three.html'), readFileSync(path.join(examples, 'three.html')));
  await inBrowser([scratch, folder], async (page, site) => {
    await page.goto(`${site}/three.html`);
    await page.waitForFunction(() => /faces/.test(document.querySelector('output').textContent));
    assert.equal(await page.textContent('output'), '5120 faces');
    await page.locator('input').fill('2');
    await page.waitForFunction(() => document.querySelector('output').textContent === '1024 faces');
    const blue = await page.evaluate(() => {
      const canvas = document.querySelector('canvas');
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d');
      context.drawImage(canvas, 0, 0);
      const {data} = context.getImageData(0, 0, copy.width, copy.height);
      let n = 0;
      for (let i = 0; i < data.length; i += 4) n += data[i + 2] > 60 && data[i + 2] > data[i] + 20 ? 1 : 0;
      return n;
    });
    assert.ok(blue > 20_000, `${blue} blue pixels`);
  });
  rmSync(scratch, {recursive: true});
});
