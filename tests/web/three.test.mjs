// Geometries of three.js keep what they carry.
import assert from 'node:assert/strict';
import path from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {folder, fromNpm, random, without} from './package.mjs';

const skip = without('three');
const THREE = skip ? null : await fromNpm('three/build/three.module.js');
const ours = skip ? null : await import(pathToFileURL(path.join(folder, 'three.js')));

const faces = (geometry) => geometry.index.count / 3;
const knot = () => new THREE.TorusKnotGeometry(1, 0.3, 200, 32);

test('normals and uv go along', {skip}, () => {
  const small = ours.simplifyGeometry(knot(), {faceRatio: 0.1});
  assert.ok(faces(small) <= 1280 && faces(small) > 1200);
  assert.deepEqual(Object.keys(small.attributes).sort(), ['normal', 'position', 'uv']);
  const {normal, position, uv} = small.attributes;
  assert.ok(normal.count === position.count && uv.count === position.count && position.array instanceof Float32Array);
  for (let v = 0; v < normal.count; ++v) {
    const length = Math.hypot(normal.getX(v), normal.getY(v), normal.getZ(v));
    assert.ok(Math.abs(length - 1) < 1e-5);
  }
  assert.ok(small.index.array instanceof Uint16Array);
});

test('a geometry without an index gets one, and is joined', {skip}, () => {
  const small = ours.simplifyGeometry(knot().toNonIndexed(), {faceRatio: 0.1});
  assert.ok(Math.abs(faces(small) - 1280) <= 1);
  assert.ok(small.attributes.position.count < 1000);
});

test('groups keep their materials', {skip}, () => {
  const box = new THREE.BoxGeometry(1, 1, 1, 10, 10, 10);
  const small = ours.simplifyGeometry(box, {facesLeft: 12});
  assert.equal(faces(small), 12);
  assert.deepEqual(
    small.groups.map(({materialIndex, count}) => [materialIndex, count]),
    [0, 1, 2, 3, 4, 5].map((i) => [i, 6]),
  );
  small.groups.forEach(({start, count, materialIndex}) => {
    for (let i = start; i < start + count; ++i) {
      const v = small.index.getX(i);
      const along = [0, 0, 1, 1, 2, 2][materialIndex];
      assert.equal(small.attributes.position.getComponent(v, along), materialIndex % 2 ? -0.5 : 0.5);
    }
  });
});

test('interleaved and normalized attributes stay what they are', {skip}, () => {
  const sphere = new THREE.SphereGeometry(1, 40, 30);
  const n = sphere.attributes.position.count;
  const data = new Float32Array(5 * n);
  for (let v = 0; v < n; ++v) {
    for (let i = 0; i < 3; ++i) data[5 * v + i] = sphere.attributes.position.getComponent(v, i);
    for (let i = 0; i < 2; ++i) data[5 * v + 3 + i] = sphere.attributes.uv.getComponent(v, i);
  }
  const buffer = new THREE.InterleavedBuffer(data, 5);
  sphere.setAttribute('position', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
  sphere.setAttribute('uv', new THREE.InterleavedBufferAttribute(buffer, 2, 3));
  const colors = new Uint8Array(4 * n).map((_, i) => [255, 128, 0, 255][i % 4]);
  sphere.setAttribute('color', new THREE.BufferAttribute(colors, 4, true));
  const small = ours.simplifyGeometry(sphere, {faceRatio: 0.2});
  const {color, position, uv} = small.attributes;
  assert.ok(color.array instanceof Uint8Array && color.normalized);
  for (let i = 0; i < color.array.length; ++i) assert.equal(color.array[i], [255, 128, 0, 255][i % 4]);
  for (let v = 0; v < position.count; ++v) {
    const length = Math.hypot(position.getX(v), position.getY(v), position.getZ(v));
    assert.ok(length > 0.95 && length < 1.05);
    assert.ok(uv.getX(v) > -0.05 && uv.getX(v) < 1.05);
  }
});

test('skin weights stay weights', {skip}, () => {
  const tube = new THREE.CylinderGeometry(1, 1, 4, 24, 40);
  const n = tube.attributes.position.count;
  const [joints, weights] = [new Uint16Array(4 * n), new Float32Array(4 * n)];
  for (let v = 0; v < n; ++v) {
    const share = (tube.attributes.position.getY(v) + 2) / 4;
    joints.set([0, 1, 0, 0], 4 * v);
    weights.set([1 - share, share, 0, 0], 4 * v);
  }
  tube.setAttribute('skinIndex', new THREE.BufferAttribute(joints, 4));
  tube.setAttribute('skinWeight', new THREE.BufferAttribute(weights, 4));
  const {position, skinIndex, skinWeight} = ours.simplifyGeometry(tube, {faceRatio: 0.2}).attributes;
  assert.ok(skinIndex.array instanceof Uint16Array);
  for (let v = 0; v < position.count; ++v) {
    let [sum, ofOne] = [0, 0];
    for (let i = 0; i < 4; ++i) {
      sum += skinWeight.getComponent(v, i);
      if (skinIndex.getComponent(v, i) === 1) ofOne += skinWeight.getComponent(v, i);
    }
    assert.ok(Math.abs(sum - 1) < 1e-5);
    assert.ok(Math.abs(ofOne - (position.getY(v) + 2) / 4) < 0.1);
  }
});

test('morph targets go along, relative or not', {skip}, () => {
  for (const isRelative of [false, true]) {
    const plane = new THREE.PlaneGeometry(1, 1, 30, 30);
    const {position} = plane.attributes;
    const target = position.clone();
    for (let v = 0; v < position.count; ++v) {
      const lift = 0.3 * position.getX(v);
      target.setXYZ(v, ...(isRelative ? [0, 0, lift] : [position.getX(v), position.getY(v), lift]));
    }
    plane.morphAttributes.position = [target];
    plane.morphTargetsRelative = isRelative;
    const small = ours.simplifyGeometry(plane, {facesLeft: 60});
    const [morph] = small.morphAttributes.position;
    assert.equal(small.morphTargetsRelative, isRelative);
    assert.equal(morph.count, small.attributes.position.count);
    for (let v = 0; v < morph.count; ++v) {
      assert.ok(Math.abs(morph.getZ(v) - 0.3 * small.attributes.position.getX(v)) < 1e-3);
    }
  }
});

test('random geometries', {skip}, () => {
  for (let seed = 0; seed < 20; ++seed) {
    const next = random(seed);
    const geometry = new THREE.SphereGeometry(1, 3 + Math.floor(20 * next()), 2 + Math.floor(20 * next()));
    const small = ours.simplifyGeometry(next() < 0.5 ? geometry : geometry.toNonIndexed(), {faceRatio: 0.5});
    for (const attribute of Object.values(small.attributes)) assert.ok(attribute.array.every(Number.isFinite));
    assert.ok(small.index.array.every((v) => v < small.attributes.position.count));
  }
});

test('in a worker', {skip}, async () => {
  const [here, there] = [
    ours.simplifyGeometry(knot(), {faceRatio: 0.1}),
    await ours.simplifyGeometryInWorker(knot(), {faceRatio: 0.1}),
  ];
  assert.deepEqual(there.attributes.position.array, here.attributes.position.array);
});

test('what it has no rule for is refused', {skip}, () => {
  assert.throws(() => ours.simplifyGeometry({}, {faceRatio: 0.1}), {name: 'WhittleError', message: /BufferGeometry/});
  assert.throws(() => ours.simplifyGeometry(new THREE.BufferGeometry(), {faceRatio: 0.1}), /no positions/);
  const part = knot();
  part.setDrawRange(0, 30);
  assert.throws(() => ours.simplifyGeometry(part, {faceRatio: 0.1}), /drawRange/);
});
