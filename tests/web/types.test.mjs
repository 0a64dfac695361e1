// The types check, and say what the JavaScript has. The examples' imports are found by a bundler.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {gzipSync} from 'node:zlib';
import {folder, npm, terrain, whittle, without} from './package.mjs';

const typescript = path.join(npm, 'typescript/bin/tsc');

function check(code) {
  const file = path.join(folder, '..', 'use.mts');
  writeFileSync(file, code);
  const run = spawnSync(
    process.execPath,
    [typescript, '--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom', '--types', '@webgpu/types', file],
    {encoding: 'utf8', cwd: path.join(folder, '..')},
  );
  rmSync(file);
  return run.stdout;
}

test('right calls check, and wrong ones do not', {skip: without('typescript') || without('three')}, () => {
  assert.equal(
    check(`
import {BufferGeometry} from 'three';
import {MeshoptSimplifier, lod, simplify, simplifyInWorker, type MeshLevel, type Result} from 'whittle-mesh';
import {simplifyGeometry} from 'whittle-mesh/three';
const mesh = {positions: new Float32Array(9), indices: [0, 1, 2]};
const small: Result = simplify(mesh, {faceRatio: '10%', effort: 'best', maxError: 0.1, acrossWalls: true});
const levels: MeshLevel[] = lod(mesh, {faceRatios: [0.5]});
const later: Promise<Result> = simplifyInWorker(mesh, {facesLeft: 1}, {signal: new AbortController().signal});
const more: Promise<MeshLevel[]> = simplifyInWorker(mesh, {}, {targets: {facesLeft: [1]}});
const [lodIndices, error]: [Uint16Array, number] = MeshoptSimplifier.simplify(new Uint16Array(3), mesh.positions, 3, 3, 1);
const geometry: BufferGeometry = simplifyGeometry(new BufferGeometry(), {ratio: 0.1, attributeWeight: {uv: 0.1}});
export {small, levels, later, more, lodIndices, error, geometry};
`),
    '',
  );
  const wrong = check(`
import {simplify} from 'whittle-mesh';
simplify({positions: [1]}, {effort: 'slow'});
simplify({positions: [1]}, {faces: 3});
simplify({}, {faceRatio: 'half'});
`);
  for (const line of [3, 4, 5]) assert.match(wrong, new RegExp(`use.mts\\(${line},`));
});

test('each option of the types is one, and takes a value', () => {
  const text = readFileSync(path.join(folder, 'options.d.ts'), 'utf8');
  const options = [...text.matchAll(/^ {2}(\w+)\?: (.+);$/gm)].map(([, name, type]) => [name, type]);
  assert.ok(options.length > 25);
  const mesh = terrain(6);
  for (const [name, type] of options) {
    const word = /'([^']+)'/.exec(type)?.[1];
    const value = type === 'boolean' ? true : type.startsWith('{') ? {uv: 1} : (word ?? (name === 'isotropic' ? 0 : 1));
    const given = {facesLeft: 9, [name]: /atio$/.test(name) && name !== 'minRadiusRatio' ? 0.5 : value};
    whittle.simplify(mesh, given);
  }
});

test('the package takes at most 400 kB, gzipped', () => {
  const shipped = readdirSync(folder).filter((name) => /\.(js|wasm)$/.test(name));
  assert.ok(shipped.includes('whittle.wasm') && shipped.length > 8);
  const size = (name) => gzipSync(readFileSync(path.join(folder, name)), {level: 9}).length;
  assert.ok(shipped.reduce((sum, name) => sum + size(name), 0) <= 400_000);
});

test('the examples are put together', {skip: without('esbuild')}, () => {
  const examples = path.join(process.env.WHITTLE_SOURCE, 'modules/web/examples');
  for (const name of ['three.js', 'babylon.js', 'fiber.jsx']) {
    const external = ['three', '@babylonjs/*', 'react', 'react/*'].map((module) => `--external:${module}`);
    const bundle = execFileSync(
      path.join(npm, '.bin/esbuild'),
      [path.join(examples, name), '--bundle', '--format=esm', '--jsx=automatic', '--external:node:*', ...external],
      {env: {...process.env, NODE_PATH: path.join(folder, '../node_modules')}, encoding: 'utf8'},
    );
    assert.match(bundle, /new URL\(".\/(whittle.wasm|worker.js)", import.meta.url\)/);
  }
});
