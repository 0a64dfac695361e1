// The calls in a worker, with progress and cancelling.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {terrain, whittle} from './package.mjs';

const {simplify, simplifyInWorker, lod} = whittle;

test('a worker gives what this thread gives', async () => {
  const mesh = terrain(60);
  assert.deepEqual(await simplifyInWorker(mesh, {faceRatio: 0.1}), simplify(mesh, {faceRatio: 0.1}));
  const targets = {faceRatios: [0.5, 0.1]};
  assert.deepEqual(await simplifyInWorker(mesh, {}, {targets}), lod(mesh, targets));
  assert.equal(mesh.positions.length, 3 * 61 * 61); // a copy went
});

test('progress', async () => {
  const told = [];
  await simplifyInWorker(terrain(60), {faceRatio: 0.1}, {onProgress: (...progress) => told.push(progress)});
  assert.deepEqual([...new Set(told.map(([stage]) => stage))], ['decimating', 'polishing']);
});

test('cancelling', async () => {
  const before = AbortSignal.abort();
  await assert.rejects(simplifyInWorker(terrain(4), {faceRatio: 0.1}, {signal: before}), {name: 'AbortError'});
  const control = new AbortController();
  const running = simplifyInWorker(
    terrain(300),
    {faceRatio: 0.1},
    {signal: control.signal, onProgress: () => control.abort()},
  );
  await assert.rejects(running, {name: 'AbortError'});
});

test('errors', async () => {
  await assert.rejects(simplifyInWorker(terrain(4), {faceRatio: 7}), {
    name: 'WhittleError',
    kind: 'invalid',
    message: /^faceRatio/,
  });
  const fails = () => {
    throw new TypeError('mine');
  };
  await assert.rejects(simplifyInWorker(terrain(60), {faceRatio: 0.1}, {onProgress: fails}), {name: 'TypeError'});
});
