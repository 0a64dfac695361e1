// Prints the tables of docs/dev/performance.md about the npm package: node tests/bench/web_peers.mjs BUILD
// Sizes, time beside the native library on one thread, and time and error beside meshoptimizer and SimplifyModifier.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import {gzipSync} from 'node:zlib';

const build = path.resolve(process.argv[2] ?? 'build/release');
const source = path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../..');
const meshes = process.env.WHITTLE_TEST_MESHES ?? path.join(source, '../shared/data/meshes');
const load = (file) => import(pathToFileURL(path.join(build, 'web', file)));

const whittle = await load('whittle/index.js');
const {MeshoptSimplifier: meshoptimizer} = await load('node_modules/meshoptimizer/meshopt_simplifier.js');
const {BufferAttribute, BufferGeometry} = await load('node_modules/three/build/three.module.js');
const {SimplifyModifier} = await load('node_modules/three/examples/jsm/modifiers/SimplifyModifier.js');
await Promise.all([whittle.ready, meshoptimizer.ready]);

const folder = mkdtempSync(path.join(tmpdir(), 'whittle-'));
const program = path.join(build, 'bin/whittle');

/** Any mesh the program reads, its triangles and vertices joined: as OBJ, which tells all digits. */
function read(name) {
  const file = path.join(folder, 'in.obj');
  execFileSync(program, ['convert', path.join(meshes, name), file, '--quiet']);
  const [positions, indices] = [[], []];
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') for (const word of words.slice(1, 4)) positions.push(Number(word));
    if (words[0] === 'f') for (const word of words.slice(1, 4)) indices.push(parseInt(word, 10) - 1);
  }
  return {positions: Float32Array.from(positions), indices: Uint32Array.from(indices), file};
}

/** Mean distance both ways, in % of the diagonal. */
function errorOf(mesh, {positions, indices}) {
  const file = path.join(folder, 'out.obj');
  const text = [];
  for (let v = 0; v < positions.length; v += 3) text.push(`v ${positions[v]} ${positions[v + 1]} ${positions[v + 2]}`);
  for (let f = 0; f < indices.length; f += 3)
    text.push(`f ${indices[f] + 1} ${indices[f + 1] + 1} ${indices[f + 2] + 1}`);
  writeFileSync(file, text.join('\n') + '\n');
  const report = JSON.parse(execFileSync(program, ['measure', mesh.file, file, '--json', '-']));
  return 100 * findKey(report, 'mean_rel');
}

function findKey(value, key) {
  if (typeof value !== 'object' || value === null) return undefined;
  if (key in value) return value[key];
  return Object.values(value)
    .map((part) => findKey(part, key))
    .find((found) => found !== undefined);
}

/** The median time of a call in ms, and its result. */
function timed(call, n = 5) {
  let result = call();
  const times = [];
  for (let i = 0; i < n; ++i) {
    const start = performance.now();
    result = call();
    times.push(performance.now() - start);
  }
  return [times.sort((a, b) => a - b)[n >> 1], result];
}

function native(mesh, options) {
  const bytes = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  writeFileSync(path.join(folder, 'positions'), bytes(Float64Array.from(mesh.positions)));
  writeFileSync(path.join(folder, 'indices'), bytes(mesh.indices));
  const job = path.join(build, 'tests/web/whittle_web_native_job');
  return Number(execFileSync(job, [folder, 'times=5', ...options], {encoding: 'utf8'}));
}

function sizes() {
  const gzipped = (name) => gzipSync(readFileSync(path.join(build, 'web/whittle', name)), {level: 9}).length;
  const scripts = [
    'engine.js',
    'in_worker.js',
    'index.js',
    'mesh.js',
    'meshoptimizer.js',
    'options.js',
    'simplify.js',
    'three.js',
    'worker.js',
  ].reduce((sum, name) => sum + gzipped(name), 0);
  console.log(
    `whittle.wasm ${(gzipped('whittle.wasm') / 1000).toFixed(1)} kB, scripts ${(scripts / 1000).toFixed(1)} kB, gzipped\n`,
  );
}

function rowOf(name, what, time, mesh, small) {
  const error = errorOf(mesh, small);
  console.log(
    `|${name}, ${mesh.indices.length / 3}|${what}|${small.indices.length / 3}|${time.toFixed(0)}|${error.toPrecision(3)}|`,
  );
}

sizes();
console.log('|mesh, faces|effort|WebAssembly, ms|native, ms|ratio|\n|-|-|-|-|-|');
const inputs = ['bunny.obj', 'fandisk.obj', 'kitten.obj', 'dragon_vrip.ply'];
for (const name of inputs) {
  const mesh = read(name);
  for (const effort of ['fast', 'normal', 'best']) {
    const [time] = timed(() => whittle.simplify(mesh, {faceRatio: 0.1, effort}));
    const other = native(mesh, ['face-ratio=10%', `effort=${effort}`]);
    console.log(
      `|${name}, ${mesh.indices.length / 3}|${effort}|${time.toFixed(0)}|${other.toFixed(0)}|${(time / other).toFixed(2)}|`,
    );
  }
}
console.log('\n|mesh, faces|by|faces left|ms|mean error, % of the diagonal|\n|-|-|-|-|-|');
for (const name of inputs) {
  const mesh = read(name);
  const {indices, positions} = mesh;
  const nFaces = Math.floor(indices.length / 30);
  for (const effort of ['fast', 'normal', 'best']) {
    rowOf(
      name,
      `Whittle, ${effort}`,
      ...((call) => [call[0], mesh, call[1]])(timed(() => whittle.simplify(mesh, {facesLeft: nFaces, effort}))),
    );
  }
  const overVertices = (simplifier) =>
    timed(() => ({positions, indices: simplifier.simplify(indices, positions, 3, 3 * nFaces, 1)[0]}));
  for (const [what, simplifier] of [
    ["Whittle's MeshoptSimplifier", whittle.MeshoptSimplifier],
    ['meshoptimizer 1.3.0', meshoptimizer],
  ]) {
    const [time, small] = overVertices(simplifier);
    rowOf(name, what, time, mesh, small);
  }
  if (indices.length / 3 > 40000) continue; // it takes minutes
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  const nVertices = whittle.simplify(mesh, {facesLeft: nFaces}).positions.length / 3;
  const [time, small] = timed(() => new SimplifyModifier().modify(geometry, positions.length / 3 - nVertices), 1);
  rowOf(name, "three.js' SimplifyModifier", time, mesh, {
    positions: small.attributes.position.array,
    indices: small.index.array,
  });
}
rmSync(folder, {recursive: true});
