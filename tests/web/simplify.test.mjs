// What simplify, lod and record promise.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {randomMesh, terrain, whittle} from './package.mjs';

const {WhittleError, lod, record, simplify} = whittle;
const isInvalid = (pattern) => (error) =>
  error instanceof WhittleError && error.kind === 'invalid' && pattern.test(error.message);

test('gives what was asked for, in the types given', () => {
  const mesh = terrain(40);
  const small = simplify(mesh, {faceRatio: 0.1});
  const n = small.indices.length / 3;
  assert.ok(n === 320 || n === 319);
  assert.ok(small.positions instanceof Float32Array && small.texcoords instanceof Float32Array);
  assert.equal(small.texcoords.length / 2, small.positions.length / 3);
  assert.equal(small.vertexMap.length, mesh.positions.length / 3);
  assert.equal(small.faceOrigins.length, n);
  assert.ok(small.met && small.report.stop === 'target');
  const wide = simplify({...mesh, positions: Float64Array.from(mesh.positions)}, {faceRatio: 0.1});
  assert.ok(wide.positions instanceof Float64Array);
  assert.deepEqual(Float32Array.from(wide.positions), small.positions);
});

test('results of random meshes are meshes', () => {
  for (let seed = 100; seed < 200; ++seed) {
    const mesh = randomMesh(seed);
    const small = simplify(mesh, {faceRatio: 0.4, effort: ['fast', 'normal', 'best'][seed % 3]});
    const n = small.positions.length / 3;
    const what = `seed ${seed}`;
    assert.ok(small.indices.length <= mesh.indices.length, what);
    assert.ok(
      small.indices.every((v) => v < n),
      what,
    );
    assert.ok(small.positions.every(Number.isFinite), what);
    assert.ok(
      small.vertexMap.every((v) => v >= -1 && v < n),
      what,
    );
    assert.ok(
      small.faceOrigins.every((f, i) => i === 0 || f > small.faceOrigins[i - 1]),
      what,
    );
    assert.ok(
      small.origins.every((v) => v < mesh.positions.length / 3),
      what,
    );
    assert.deepEqual(small, simplify(mesh, {faceRatio: 0.4, effort: ['fast', 'normal', 'best'][seed % 3]}), what);
  }
});

test('vertices without an index are joined where they lie together', () => {
  const mesh = terrain(20);
  const positions = Float32Array.from(mesh.indices, (v) => v).length && new Float32Array(3 * mesh.indices.length);
  mesh.indices.forEach((v, i) => positions.set(mesh.positions.subarray(3 * v, 3 * v + 3), 3 * i));
  const small = simplify({positions}, {facesLeft: 80});
  assert.equal(small.indices.length / 3, 80);
  assert.equal(small.report.verticesBefore, 21 * 21);
});

test('seams of attributes stay closed', () => {
  const mesh = terrain(20);
  const half = mesh.indices.length / 2;
  // The second half of the faces has vertices of its own, with texture coordinates elsewhere.
  const n = mesh.positions.length / 3;
  const twice = {
    positions: Float32Array.from([...mesh.positions, ...mesh.positions]),
    texcoords: Float32Array.from([...mesh.texcoords, ...mesh.texcoords.map((t) => t + 2)]),
    indices: mesh.indices.map((v, i) => (i < half ? v : v + n)),
  };
  const small = simplify(twice, {facesLeft: 60});
  const edges = new Map();
  const key = (v) => small.positions.slice(3 * v, 3 * v + 3).join();
  for (let f = 0; f < small.indices.length; f += 3) {
    for (let c = 0; c < 3; ++c) {
      const edge = [key(small.indices[f + c]), key(small.indices[f + ((c + 1) % 3)])].sort().join(';');
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    }
  }
  const open = [...edges.keys()].filter((edge) => edges.get(edge) === 1);
  const onBorder = (point) =>
    point
      .split(',')
      .slice(0, 2)
      .some((x) => Math.abs(x) < 1e-2 || Math.abs(x - 1) < 1e-2);
  assert.ok(open.length > 0 && open.every((edge) => edge.split(';').every(onBorder)));
  assert.ok(small.texcoords.some((t) => t > 1.5));
});

test('locked vertices and groups stay', () => {
  const mesh = terrain(20);
  const locked = new Uint8Array(21 * 21);
  locked[220] = 1;
  const faceGroups = Uint32Array.from({length: 800}, (_, f) => (f < 400 ? 0 : 1));
  const small = simplify({...mesh, locked, faceGroups}, {facesLeft: 60});
  const v = small.vertexMap[220];
  assert.deepEqual(small.positions.slice(3 * v, 3 * v + 3), mesh.positions.slice(660, 663));
  assert.deepEqual([...new Set(small.faceGroups)].sort(), [0, 1]);
});

test('a limit of the error is proven', () => {
  const mesh = terrain(30);
  const {report, met} = simplify(mesh, {maxError: 0.01});
  assert.ok(met && report.provenError > 0 && report.provenError <= 0.0100001);
});

test('levels of detail', () => {
  const levels = lod(terrain(40), {faceRatios: [0.5, 0.2, 0.05]});
  assert.deepEqual(
    levels.map((level) => level.indices.length / 3),
    [1599, 639, 160],
  ); // a contraction takes two faces or one
  assert.throws(() => lod(terrain(4), {}), isInvalid(/facesLeft or faceRatios/));
  assert.throws(() => lod(terrain(4), {facesLeft: [4, 8]}), isInvalid(/descending/));
});

test('a recording has the result, and every level on the way', () => {
  const mesh = {...terrain(30, (x, y) => 0.3 * Math.sin(9 * x) * Math.cos(7 * y)), normals: undefined};
  for (const options of [{effort: 'fast', facesLeft: 40}, {effort: 'normal', facesLeft: 100}, {effort: 'best', verticesLeft: 80}]) {
    const recording = record(mesh, options);
    const result = simplify(mesh, options);
    for (const name of ['positions', 'indices', 'vertexMap', 'faceOrigins']) {
      assert.deepEqual(recording.last[name], result[name], `${name}, ${JSON.stringify(options)}`);
    }
    assert.deepEqual(recording.level({facesLeft: 0}), recording.last);
    const whole = recording.level({facesLeft: 1800});
    assert.equal(whole.indices.length, mesh.indices.length);
    assert.deepEqual([whole.report.contractions, whole.report.maxCost], [0, 0]);
    let before = whole;
    for (const n of [1700, 900, 301]) {
      const level = recording.level({facesLeft: n});
      const nFaces = level.indices.length / 3;
      assert.ok(nFaces <= n && nFaces > n - 4, `${nFaces} faces, not ${n}`);
      assert.ok(level.report.contractions > before.report.contractions && level.report.maxCost >= before.report.maxCost);
      assert.equal(level.texcoords.length / 2, level.positions.length / 3);
      assert.ok(level.vertexMap.every((v) => v < level.positions.length / 3));
      recording.level({verticesLeft: 500}); // back, and there again
      assert.deepEqual(recording.level({facesLeft: n}), level);
      before = level;
    }
  }
});

test('a level of a recording is what a shorter run gives', () => {
  const {positions, indices} = terrain(24, (x, y) => 0.2 * Math.sin(11 * x * y));
  const options = {effort: 'fast', cost: 'quadric'};
  const recording = record({positions, indices}, {...options, facesLeft: 20});
  for (const facesLeft of [800, 300, 90]) {
    const level = recording.level({facesLeft});
    const result = simplify({positions, indices}, {...options, facesLeft});
    for (const name of ['positions', 'indices']) assert.deepEqual(level[name], result[name], `${name} at ${facesLeft}`);
  }
});

test('what a recording refuses', () => {
  const mesh = terrain(6);
  assert.throws(() => record(mesh, {}), isInvalid(/no target/));
  const recording = record(mesh, {facesLeft: 10});
  for (const count of [{}, {facesLeft: -1}, {facesLeft: 1.5}, {facesLeft: 9, verticesLeft: 9}]) {
    assert.throws(() => recording.level(count), isInvalid(/level: /));
  }
  assert.ok(recording.level({facesLeft: 10}).indices.length > 0);
});

test('errors name the option and what is valid', () => {
  const mesh = terrain(4);
  for (const [options, pattern] of [
    [{}, /no target/],
    [{faceRatio: 2}, /^faceRatio: '2' isn't valid: a share/],
    [{faceRatio: '120%'}, /^faceRatio/],
    [{facesLeft: 1.5}, /^facesLeft: '1.5' isn't valid: a whole number/],
    [{facesLeft: 0}, /^facesLeft/],
    [{faceRatio: 0.5, effort: 'slow'}, /^effort: 'slow' isn't valid: fast\|normal\|best/],
    [{faceRatio: 0.5, boundary: 3}, /^boundary: '3'/],
    [{faceRatio: 0.5, acrossWalls: 1}, /^acrossWalls/],
    [{faceRatio: 0.5, featureAngle: 181}, /^featureAngle/],
    [{faceRatio: 0.5, attributeWeight: {uv: -1}}, /^attributeWeight.uv/],
    [{maxError: 0}, /^maxError/],
    [{face_ratio: 0.5}, /no option face_ratio/],
    [{faces: 5}, /no option faces/],
    [{'face-ratio': 0.5}, /no option face-ratio/],
  ]) {
    assert.throws(() => simplify(mesh, options), isInvalid(pattern), JSON.stringify(options));
  }
});

test('meshes that are none are refused', () => {
  const mesh = terrain(4);
  const options = {faceRatio: 0.5};
  assert.throws(() => simplify(null, options), isInvalid(/no object/));
  assert.throws(() => simplify({}, options), isInvalid(/positions is no array/));
  assert.throws(() => simplify({positions: [0, 1]}, options), isInvalid(/positions has 2 numbers/));
  assert.throws(() => simplify({...mesh, indices: [0, 1]}, options), isInvalid(/indices has 2 numbers/));
  assert.throws(() => simplify({...mesh, indices: [0, 1, 99]}, options), isInvalid(/no vertex 99/));
  assert.throws(
    () => simplify({...mesh, positions: mesh.positions.map((x, i) => (i === 4 ? NaN : x))}, options),
    isInvalid(/finite/),
  );
  assert.throws(() => simplify({...mesh, normals: [1]}, options), isInvalid(/normals has 1 numbers, not 75/));
  assert.throws(
    () => simplify({...mesh, attributes: {heat: {values: mesh.positions, kind: 'warmth'}}}, options),
    isInvalid(/heat: 'warmth'/),
  );
  assert.equal(simplify({positions: [], indices: []}, options).indices.length, 0);
});

test('after an error the next call works', () => {
  const mesh = terrain(20);
  const before = simplify(mesh, {facesLeft: 50});
  assert.throws(() => simplify(mesh, {faceRatio: 5}));
  assert.throws(() => simplify(mesh, {facesLeft: 50, onProgress: () => false}), {name: 'AbortError'});
  assert.throws(
    () =>
      simplify(mesh, {
        facesLeft: 50,
        onProgress: () => {
          throw new TypeError('mine');
        },
      }),
    {name: 'TypeError', message: 'mine'},
  );
  assert.deepEqual(simplify(mesh, {facesLeft: 50}), before);
});

test('progress never falls, and ends at 1', () => {
  const told = [];
  simplify(terrain(100), {
    faceRatio: 0.1,
    onProgress: (stage, fraction, faces) => void told.push([stage, fraction, faces]),
  });
  const polishing = told.filter(([stage]) => stage === 'polishing');
  assert.ok(told.length > 4 && polishing.length > 0);
  assert.equal(polishing.at(-1)[1], 1);
  assert.ok(told.every(([, fraction]) => fraction >= 0 && fraction <= 1));
});

test('calls within onProgress work', () => {
  const mesh = terrain(20);
  const alone = simplify(mesh, {facesLeft: 50});
  let within = null;
  const outer = simplify(mesh, {facesLeft: 50, onProgress: () => void (within ??= simplify(mesh, {facesLeft: 50}))});
  assert.deepEqual(within, alone);
  assert.deepEqual(outer, alone);
});

test('too little memory is an error, and calls after it work', () => {
  const vertex = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const isMemory = (error) =>
    error instanceof WhittleError && error.kind === 'memory' && /out of memory/.test(error.message);
  const n = 400_000;
  for (const itemSize of [1000, 1400]) {
    // 3.2 GB of doubles, and more than there are addresses for
    const attributes = {much: {values: new Uint8Array(itemSize * n), itemSize}};
    assert.throws(
      () => simplify({positions: new Uint8Array(3 * n), indices: [0, 1, 2], attributes}, {facesLeft: 1}),
      isMemory,
    );
  }
  assert.equal(simplify({positions: vertex, indices: [0, 1, 2]}, {facesLeft: 1}).indices.length, 3);
});
