// Results have the bytes that the native library gives, and the program.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {test} from 'node:test';
import {random, randomMesh, terrain, whittle} from './package.mjs';

const {WHITTLE_WEB_NATIVE_JOB: nativeJob, WHITTLE_TEST_MESHES: meshes} = process.env;
const kebab = {facesLeft: 'faces', verticesLeft: 'vertices'};
const nameOf = (option) => kebab[option] ?? option.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());
const bytes = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);

/** What the native library makes of it. */
function natively(mesh, options) {
  const folder = mkdtempSync(path.join(tmpdir(), 'whittle-'));
  try {
    const put = (name, values) => values && writeFileSync(path.join(folder, name), bytes(values));
    put('positions', Float64Array.from(mesh.positions));
    put('indices', Uint32Array.from(mesh.indices));
    put('normals', mesh.normals);
    put('uv', mesh.attributes && Float64Array.from(mesh.attributes.uv.values));
    put('groups', mesh.faceGroups);
    const given = Object.entries(options).map(([name, value]) => `${nameOf(name)}=${value}`);
    execFileSync(nativeJob, [folder, ...given]);
    const got = (name) => readFileSync(path.join(folder, `result_${name}`));
    return {
      positions: got('positions'),
      indices: got('indices'),
      normals: got('normals'),
      uv: mesh.attributes ? got('uv') : null,
      vertexMap: got('vertex_map'),
      faceOrigins: got('face_origins'),
    };
  } finally {
    rmSync(folder, {recursive: true});
  }
}

function checkSame(mesh, options, what) {
  const input = {...mesh, positions: Float64Array.from(mesh.positions)};
  const small = whittle.simplify(input, options);
  const native = natively(mesh, options);
  for (const name of ['positions', 'indices', 'vertexMap', 'faceOrigins']) {
    assert.ok(bytes(small[name]).equals(native[name]), `${name} of ${what}, ${JSON.stringify(options)}`);
  }
  if (small.normals) assert.ok(bytes(small.normals).equals(native.normals), `normals of ${what}`);
  if (native.uv)
    assert.ok(bytes(small.attributes.uv.values).equals(native.uv), `uv of ${what}, ${JSON.stringify(options)}`);
  return small;
}

function withAttributes(mesh) {
  const uv = {values: Float64Array.from(mesh.texcoords), itemSize: 2, kind: 'texcoord'};
  const normals = new Float32Array(mesh.positions.length);
  for (let v = 0; v < normals.length; v += 3) normals[v + 2] = 1;
  const faceGroups = Uint32Array.from({length: mesh.indices.length / 3}, (_, f) =>
    f < mesh.indices.length / 5 ? 0 : 1,
  );
  return {positions: mesh.positions, indices: mesh.indices, normals, attributes: {uv}, faceGroups};
}

const optionSets = [
  {faceRatio: 0.3, effort: 'fast'},
  {faceRatio: 0.3},
  {faceRatio: 0.3, effort: 'best'},
  {verticesLeft: 20, boundary: 'locked'},
  {ratio: '20%', cost: 'lindstrom-turk'},
  {facesLeft: 9, cost: 'midpoint', topology: 'free'},
  {faceRatio: 0.2, cost: 'quadric', isotropic: 0.3},
  {faceRatio: 0.3, placement: 'endpoint', cost: 'quadric', weights: 'uniform'},
  {maxError: '2%'},
  {faceRatio: 0.4, featureAngle: 30, minRadiusRatio: 0.1, valence: 0.5},
  {faceRatio: 0.3, selfIntersections: 'refuse', maxNormalFlip: 90},
  {facesLeft: 4, threshold: '20%', topology: 'free', seams: 'keep'},
];

test('small random meshes', () => {
  for (let seed = 0; seed < 60; ++seed) {
    const mesh = randomMesh(seed);
    const {positions, indices} = mesh;
    checkSame(
      seed % 2 ? withAttributes(mesh) : {positions, indices},
      optionSets[seed % optionSets.length],
      `seed ${seed}`,
    );
  }
});

test('meshes in blocks', () => {
  const next = random(1);
  const mesh = terrain(160, (x, y) => 0.1 * Math.sin(20 * x) * Math.cos(13 * y) + 0.001 * next());
  for (const options of [{faceRatio: 0.1, effort: 'fast'}, {faceRatio: 0.1}, {maxError: '0.3%'}]) {
    checkSame(withAttributes(mesh), options, 'a terrain');
  }
});

/** Vertices and faces of an OBJ file of triangles. */
function readObj(file) {
  const [positions, indices] = [[], []];
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') positions.push(...words.slice(1, 4).map(Number));
    if (words[0] === 'f') indices.push(...words.slice(1, 4).map((word) => parseInt(word, 10) - 1));
  }
  return {positions: Float64Array.from(positions), indices: Uint32Array.from(indices)};
}

const bunny = path.join(meshes, 'bunny.obj');
test('real meshes', {skip: !existsSync(bunny) && 'the folder of real meshes is not there'}, () => {
  for (const name of ['bunny.obj', 'kitten.obj', 'fandisk.obj']) {
    const mesh = readObj(path.join(meshes, name));
    for (const effort of ['fast', 'normal', 'best']) checkSame(mesh, {faceRatio: 0.1, effort}, name);
  }
});

test('the program gives them, too', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'whittle-'));
  try {
    const mesh = terrain(40);
    const text = [];
    for (let v = 0; v < mesh.positions.length; v += 3) text.push('v ' + mesh.positions.slice(v, v + 3).join(' '));
    for (let f = 0; f < mesh.indices.length; f += 3)
      text.push('f ' + Array.from(mesh.indices.slice(f, f + 3), (v) => v + 1).join(' '));
    const [from, to] = [path.join(folder, 'in.obj'), path.join(folder, 'out.obj')];
    writeFileSync(from, text.join('\n') + '\n');
    execFileSync(process.env.WHITTLE_PROGRAM, ['simplify', from, '-o', to, '--face-ratio', '10%', '--quiet']);
    const small = whittle.simplify(
      {positions: Float64Array.from(mesh.positions), indices: mesh.indices},
      {faceRatio: '10%'},
    );
    const written = readObj(to);
    assert.deepEqual(Array.from(written.indices), Array.from(small.indices));
    assert.deepEqual(Array.from(written.positions), Array.from(small.positions));
  } finally {
    rmSync(folder, {recursive: true});
  }
});
