// The module of the page that simplifies: it writes the files that the program writes, byte for byte.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {after, test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {terrain} from './package.mjs';

const {WHITTLE_VIEWER: viewer, WHITTLE_PAGE_MODULE: file, WHITTLE_SOURCE: source, WHITTLE_PROGRAM: program} = process.env;
const {WHITTLE_TEST_MESHES: meshes} = process.env;
const folder = mkdtempSync(path.join(tmpdir(), 'whittle-page-'));
after(() => rmSync(folder, {recursive: true}));

const packages = path.join(viewer, 'node_modules');
const esbuild = createRequire(path.join(packages, 'x.js'))('esbuild');
await esbuild.build({
  stdin: {
    contents: `export {Engine} from ${JSON.stringify(path.join(source, 'modules/web/page/src/engine.js'))};
      export {MeshoptDecoder} from 'meshoptimizer';`,
    resolveDir: viewer,
  },
  bundle: true,
  format: 'esm',
  nodePaths: [packages],
  outfile: path.join(folder, 'engine.mjs'),
});
const {Engine, MeshoptDecoder} = await import(pathToFileURL(path.join(folder, 'engine.mjs')));
await MeshoptDecoder.ready;
const compiled = await WebAssembly.compile(readFileSync(file));

/** \param input a path; files of its folder are there, too \return {engine, facts} */
function opened(input, onProgress = () => {}) {
  const engine = new Engine(compiled, onProgress);
  const from = path.dirname(input);
  for (const name of readdirSync(from)) {
    const one = path.join(from, name);
    if (one === input || /\.(bin|mtl|png|jpg)$/.test(name)) engine.files.set(name, readFileSync(one));
  }
  return {engine, facts: engine.call('open_session', path.basename(input))};
}

/** What the program writes: its file, and those beside it. */
function written(input, format, options) {
  const to = mkdtempSync(path.join(folder, 'out-'));
  const name = path.basename(input).replace(/\..*$/, `.${format}`);
  execFileSync(program, ['simplify', input, '-o', path.join(to, name), '--quiet', ...options]);
  return new Map(readdirSync(to, {recursive: true}).map((one) => [one, readFileSync(path.join(to, one))]));
}

function checkSame(input, {format, faces, maxError, effort = 'normal'}) {
  const {engine, facts} = opened(input);
  const to = format ?? facts.format;
  engine.call('simplify_session', effort, faces ?? NaN, maxError ?? NaN);
  engine.call('write_result', to);
  const ours = engine.takeOutputs();
  const target = faces ? ['--faces', String(faces)] : ['--max-error', String(maxError)];
  const theirs = written(input, to, [...target, '--effort', effort]);
  const what = `${path.basename(input)} to ${to}, ${target.join(' ')}, ${effort}`;
  assert.deepEqual(ours.map(({name}) => name).sort(), [...theirs.keys()].sort(), what);
  for (const {name, bytes} of ours) assert.ok(theirs.get(name).equals(bytes), `${name} of ${what}`);
}

const data = (name) => path.join(source, 'data', name);

test('each format, as the program writes it', () => {
  for (const [name, faces] of [['blob.obj', 500], ['bracket.stl', 100], ['cylinder.off', 60], ['knot.ply', 900], ['terrain.ply', 300]]) {
    checkSame(data(name), {faces});
    checkSame(data(name), {faces, format: 'glb'});
  }
  for (const format of ['obj', 'off', 'ply', 'stl']) checkSame(data('knot.ply'), {faces: 500, format});
});

test('each effort, and a proven error', () => {
  for (const effort of ['fast', 'normal', 'best']) checkSame(data('blob.obj'), {faces: 300, effort});
  checkSame(data('blob.obj'), {maxError: 0.01});
  checkSame(data('blob.obj'), {maxError: 0.01, format: 'stl'}); // a proof of another file
});

/** A terrain with a material library and a texture. */
function texturedTerrain() {
  const {positions, texcoords, indices} = terrain(20);
  const triples = (array, n) => Array.from({length: array.length / n}, (_, i) => [...array.slice(n * i, n * i + n)]);
  const lines = ['mtllib hills.mtl', ...triples(positions, 3).map((p) => `v ${p.join(' ')}`),
    ...triples(texcoords, 2).map((p) => `vt ${p.join(' ')}`), 'usemtl grass',
    ...triples(indices, 3).map((f) => `f ${f.map((v) => `${v + 1}/${v + 1}`).join(' ')}`)];
  writeFileSync(path.join(folder, 'hills.obj'), lines.join('\n') + '\n');
  writeFileSync(path.join(folder, 'hills.mtl'), 'newmtl grass\nKd 0 1 0\nmap_Kd hills.png\n');
  const pixel = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==';
  writeFileSync(path.join(folder, 'hills.png'), Buffer.from(pixel, 'base64'));
  return path.join(folder, 'hills.obj');
}

test('a mesh with a material library and a texture, and glTF made of it', () => {
  const input = texturedTerrain();
  checkSame(input, {faces: 100});
  checkSame(input, {faces: 100, format: 'glb'});
  const glb = path.join(folder, 'hills.glb');
  execFileSync(program, ['convert', input, glb, '--quiet']);
  checkSame(glb, {faces: 100});
  checkSame(glb, {faces: 100, format: 'ply'}); // whose run is of the scene
  const {engine} = opened(glb);
  engine.call('record_levels');
  assert.equal(engine.page().json.images.length, 1);
});

test('glTF without the files of its textures is drawn plain, and simplified all the same', () => {
  const {positions, indices} = terrain(8);
  const bytes = Buffer.concat([Buffer.from(Float32Array.from(positions).buffer), Buffer.from(indices.buffer)]);
  const views = [{buffer: 0, byteLength: 4 * positions.length}, {buffer: 0, byteOffset: 4 * positions.length, byteLength: 4 * indices.length}];
  writeFileSync(path.join(folder, 'bare.gltf'), JSON.stringify({
    asset: {version: '2.0'},
    buffers: [{byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}`}],
    bufferViews: views,
    accessors: [{bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3', min: [0, 0, -1], max: [1, 1, 1]},
      {bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR'}],
    images: [{uri: 'lost.jpg'}],
    textures: [{source: 0}],
    materials: [{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
    nodes: [{mesh: 0}],
    scenes: [{nodes: [0]}],
    scene: 0,
  }));
  const {engine, facts} = opened(path.join(folder, 'bare.gltf'));
  assert.match(facts.warnings.join(), /lost\.jpg is not among the files/);
  engine.call('record_levels');
  engine.call('simplify_session', 'normal', 40, NaN);
  assert.equal(engine.page().json.results[0].faces, 40);
  engine.call('write_result', 'glb');
  assert.equal(engine.takeOutputs().length, 1);
});

test('compressed glTF', () => {
  const packed = path.join(folder, 'packed.glb');
  execFileSync(program, ['simplify', data('blob.obj'), '-o', packed, '--faces', '2000', '--compress', '--quiet']);
  checkSame(packed, {faces: 300});
});

test('a recording: levels, and their errors', () => {
  const stages = new Set();
  const {engine, facts} = opened(data('blob.obj'), ({stage}) => stages.add(stage));
  engine.call('record_levels');
  const {json, bytes} = engine.page();
  assert.equal(json.original.faces, facts.faces);
  assert.ok(json.recording.steps > 0);
  assert.ok(json.original.positions.at + json.original.positions.bytes <= bytes.byteLength);
  const points = [];
  for (let point; (point = engine.call('measure_next_level')) !== null;) points.push(point);
  points.sort((a, b) => b.faces - a.faces);
  assert.ok(points.length > 8);
  assert.deepEqual(points[0], {faces: facts.faces, mean: 0, max: 0});
  assert.ok(points.at(-1).faces < facts.faces / 50);
  assert.ok(points.at(-1).max > points[3].max && points[3].max > 0);
  assert.deepEqual(engine.page().json.recording.levels, points);
  assert.ok(stages.has('decimating') && stages.has('measuring'));
});

test('a result: its page has the original, the levels and the result, and the error that measure finds', () => {
  const {engine} = opened(data('blob.obj'));
  engine.call('record_levels');
  const facts = engine.call('simplify_session', 'normal', 400, NaN);
  const error = engine.call('measure_result');
  assert.deepEqual([facts.faces, facts.met, facts.proven], [400, true, null]);
  const {json} = engine.page();
  assert.equal(json.results[0].faces, 400);
  assert.deepEqual(json.results[0].error, error);
  const out = path.join(folder, 'blob400.obj');
  engine.call('write_result', 'obj');
  writeFileSync(out, engine.takeOutputs()[0].bytes);
  const measured = JSON.parse(execFileSync(program, ['measure', data('blob.obj'), out, '--samples', '100000', '--json', '-', '--quiet']));
  assert.ok(Math.abs(measured.mean - error.mean) < 1e-3 * error.mean);
});

test('a mesh of more faces than are drawn', {skip: !existsSync(path.join(meshes, 'dragon_vrip.ply')) && 'no real meshes here'}, () => {
  const {engine, facts} = opened(path.join(meshes, 'dragon_vrip.ply'));
  engine.call('record_levels');
  const {original, recording} = engine.page().json;
  assert.ok(original.faces <= 100000 && original.faces_of_file === facts.faces && recording.steps > 0);
  checkSame(path.join(meshes, 'dragon_vrip.ply'), {faces: 40000, effort: 'fast'});
});

test('what it refuses, in the words of the program', () => {
  const bad = path.join(folder, 'bad.ply');
  const whole = readFileSync(data('knot.ply'));
  for (const bytes of [whole.subarray(0, whole.length / 2), Buffer.from('no mesh'), Buffer.alloc(0)]) {
    writeFileSync(bad, bytes);
    let words = '';
    try {
      execFileSync(program, ['simplify', bad, '-o', path.join(folder, 'x.ply'), '--faces', '9'], {stdio: 'pipe', cwd: folder});
    } catch (error) {
      words = error.stderr.toString();
    }
    assert.throws(() => opened(bad), (error) => {
      assert.equal(error.kind, 'invalid');
      assert.ok(words.includes(error.message.slice(error.message.indexOf(': '))), `${error.message} | ${words}`);
      return true;
    });
  }
});
