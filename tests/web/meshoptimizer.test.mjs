// The calls of meshoptimizer's MeshoptSimplifier: checks and values as meshoptimizer's own.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {fromNpm, randomMesh, terrain, whittle, without} from './package.mjs';

const {MeshoptSimplifier: ours} = whittle;
const skip = without('meshoptimizer');
const theirs = skip ? null : (await fromNpm('meshoptimizer/meshopt_simplifier.js')).MeshoptSimplifier;
await theirs?.ready;

test('has all calls', {skip}, () => {
  assert.deepEqual(Object.keys(ours).sort(), Object.keys(theirs).sort());
  assert.equal(ours.supported, true);
});

test('faces are over the vertices given, as many as asked for', {skip}, () => {
  const {positions, indices} = terrain(40);
  for (const [Type, flags] of [
    [Uint32Array, []],
    [Uint16Array, ['LockBorder']],
    [Int32Array, ['Prune', 'Permissive']],
  ]) {
    const given = Type.from(indices);
    const [lod, error] = ours.simplify(given, positions, 3, 900, 1, flags);
    const [other, otherError] = theirs.simplify(given, positions, 3, 900, 1, flags);
    assert.ok(lod instanceof Type && other instanceof Type);
    assert.ok(Math.abs(lod.length - 900) <= 6, `${lod.length}`);
    assert.ok(lod.every((v) => v < positions.length / 3));
    assert.ok(error > 0 && otherError > 0 && error < 0.1);
  }
});

test('an error ends the run', {skip}, () => {
  const {positions, indices} = terrain(40);
  const [lod, error] = ours.simplify(indices, positions, 3, 3, 0.01);
  assert.ok(error <= 0.01 && lod.length > 3 && lod.length < indices.length);
  const scaled = positions.map((x) => 8 * x);
  assert.deepEqual(ours.simplify(indices, scaled, 3, 3, 0.01), [lod, error]);
  assert.deepEqual(ours.simplify(indices, scaled, 3, 3, 0.08, ['ErrorAbsolute'])[0], lod);
  assert.deepEqual(ours.simplify(indices, positions, 3, indices.length, 0)[0], indices);
});

test('strides and locks', {skip}, () => {
  const {positions, texcoords, indices} = terrain(20);
  const n = positions.length / 3;
  const wide = new Float32Array(5 * n);
  for (let v = 0; v < n; ++v) wide.set(positions.subarray(3 * v, 3 * v + 3), 5 * v);
  assert.deepEqual(ours.simplify(indices, wide, 5, 300, 1), ours.simplify(indices, positions, 3, 300, 1));
  const lock = new Uint8Array(n).fill(1, 0, 21);
  const [lod] = ours.simplifyWithAttributes(indices, positions, 3, texcoords, 2, [1, 1], lock, 300, 1);
  for (let v = 0; v < 21; ++v) assert.ok(lod.includes(v), `${v}`);
});

test('seams open nowhere', {skip}, () => {
  for (let seed = 0; seed < 20; ++seed) {
    const {positions, indices} = randomMesh(seed);
    const apart = new Float32Array(3 * indices.length);
    indices.forEach((v, i) => apart.set(positions.subarray(3 * v, 3 * v + 3), 3 * i));
    const own = Uint32Array.from(indices, (_, i) => i);
    const remap = ours.generatePositionRemap(apart, 3);
    assert.deepEqual(remap, theirs.generatePositionRemap(apart, 3));
    assert.ok(ours.simplify(own, apart, 3, 0, 1)[0].length <= own.length);
  }
});

test('compactMesh and getScale give the same', {skip}, () => {
  for (let seed = 0; seed < 20; ++seed) {
    const {positions, indices} = randomMesh(seed);
    const some = indices.slice(0, 30).reverse();
    const [a, b] = [some.slice(), some.slice()];
    assert.deepEqual(ours.compactMesh(a), theirs.compactMesh(b));
    assert.deepEqual(a, b);
    assert.ok(Math.abs(ours.getScale(positions, 3) - theirs.getScale(positions, 3)) < 1e-6);
  }
});

test('simplifyPrune drops small parts', {skip}, () => {
  const {positions, indices} = terrain(20);
  const triangle = Float32Array.from([3, 0, 0, 3.01, 0, 0, 3, 0.01, 0]);
  const both = Float32Array.from([...positions, ...triangle]);
  const n = positions.length / 3;
  const all = Uint32Array.from([...indices, n, n + 1, n + 2]);
  const left = ours.simplifyPrune(all, both, 3, 0.05);
  assert.deepEqual(Array.from(left), Array.from(indices));
  assert.equal(ours.simplifyPrune(all, both, 3, 1e-6).length, all.length);
});

test('wrong arguments are refused as by meshoptimizer', {skip}, () => {
  const {positions, indices} = terrain(4);
  for (const given of [
    [[0, 1, 2], positions, 3, 3, 1],
    [indices.slice(1), positions, 3, 3, 1],
    [indices, Array.from(positions), 3, 3, 1],
    [indices, positions, 2, 3, 1],
    [indices, positions, 7, 3, 1],
    [indices, positions, 3, 4, 1],
    [indices, positions, 3, indices.length + 3, 1],
    [indices, positions, 3, 3, -1],
    [indices, positions, 3, 3, 1, ['Nothing']],
  ]) {
    assert.throws(() => theirs.simplify(...given), {message: 'Assertion failed'});
    assert.throws(() => ours.simplify(...given), {message: 'Assertion failed'});
  }
});

test('calls without an equivalent say so', {skip}, () => {
  for (const name of ['simplifyWithUpdate', 'simplifySloppy', 'simplifyPoints', 'remesh']) {
    assert.throws(() => ours[name](), {name: 'WhittleError', message: new RegExp(name)});
  }
});
