// build.mjs FOLDER WASM OUT.html: puts the page that simplifies together: one file, with all that it runs.
// FOLDER has node_modules with what the viewer's package.json names; WASM is what the worker runs.
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {bundler, controls, filled, hash, packed} from '../../report/viewer/bundle.mjs';

const [folder, wasm, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const bundle = bundler(folder);

const viewer = await bundle(join(here, 'src/main.js'));
const worker = await bundle(join(here, 'src/worker.js'));
const script = await bundle(join(here, '../../report/viewer/src/loader.js'));
const style = await bundle(join(here, 'page.css'));
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} ${hash(viewer)} blob: 'wasm-unsafe-eval'`,
  'worker-src blob:',
  'img-src blob: data:',
  `style-src ${hash(style)}`,
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

writeFileSync(output, filled(readFileSync(join(here, 'page.html'), 'utf8'),
  {policy, viewer: packed(viewer), worker, wasm: packed(readFileSync(wasm)), script, style, controls: controls()}));
