// The calls of meshoptimizer's MeshoptSimplifier, by Whittle: same arguments, checks and values returned.
import {ready, withEngine} from './engine.js';
import {WhittleError} from './errors.js';
import {simplify} from './simplify.js';

const flagNames = [
  'LockBorder',
  'Sparse',
  'ErrorAbsolute',
  'Prune',
  'Regularize',
  'Permissive',
  'RegularizeLight',
  'PreserveFolds',
  'ErrorClamped',
];

function check(isSo) {
  if (!isSo) throw new Error('Assertion failed');
}

function checkIndices(indices) {
  check([Uint32Array, Int32Array, Uint16Array, Int16Array].some((Type) => indices instanceof Type));
  check(indices.length % 3 === 0);
}

function checkPositions(positions, stride) {
  check(positions instanceof Float32Array);
  check(positions.length % stride === 0);
  check(stride >= 3);
}

function checkTarget(indices, count, error) {
  check(count >= 0 && count <= indices.length);
  check(count % 3 === 0);
  check(error >= 0);
}

function flagsOf(flags) {
  for (const flag of flags ?? []) check(flagNames.includes(flag));
  return new Set(flags ?? []);
}

function packed(positions, stride) {
  const n = positions.length / stride;
  const result = new Float64Array(3 * n);
  for (let v = 0; v < n; ++v) for (let i = 0; i < 3; ++i) result[3 * v + i] = positions[v * stride + i];
  return result;
}

/** The greatest of the three extents. */
function getScale(positions, stride) {
  checkPositions(positions, stride);
  let scale = 0;
  for (let i = 0; i < 3; ++i) {
    let [low, high] = [Infinity, -Infinity];
    for (let at = i; at < positions.length; at += stride) {
      low = Math.min(low, positions[at]);
      high = Math.max(high, positions[at]);
    }
    scale = Math.max(scale, high - low);
  }
  return positions.length === 0 ? 0 : scale;
}

/** A run over the vertices as they are. */
function overVertices(indices, positions, stride, locked, count, error, flags) {
  const nIndices = indices.length;
  const unit = flags.has('ErrorAbsolute') ? 1 : getScale(positions, stride);
  const points = packed(positions, stride);
  return withEngine((engine) => {
    engine.begin(points.length / 3, nIndices / 3, 0);
    new Float64Array(engine.memory.buffer, engine.positions(), points.length).set(points);
    new Uint32Array(engine.memory.buffer, engine.faces(), nIndices).set(indices);
    if (locked) {
      const at = engine.locked();
      const bits = new Uint8Array(engine.memory.buffer, at, locked.length);
      for (let v = 0; v < locked.length; ++v) bits[v] = locked[v] & 1;
    }
    setFlags(engine, flags);
    // Where all faces may go, one is asked for: nothing gets below it.
    const reached = engine.simplify_indices(Math.max(1, count / 3), error * unit, flags.has('Permissive') ? 1 : 0);
    const faces = new Uint32Array(engine.memory.buffer, engine.result_faces(0), 3 * engine.result_n_faces(0)).slice();
    const result = indices instanceof Uint32Array ? faces : new indices.constructor(faces);
    return [result, Math.fround(unit > 0 ? reached / unit : 0)];
  });
}

function setFlags(engine, flags) {
  const set = (name, text, number) => {
    for (const [reserve, value] of [
      [engine.name_of, name],
      [engine.word_of, text],
    ]) {
      const bytes = new TextEncoder().encode(value);
      const at = reserve(bytes.length);
      new Uint8Array(engine.memory.buffer, at, bytes.length).set(bytes);
    }
    engine.option(number, 0);
  };
  if (flags.has('LockBorder')) set('boundary', 'locked', NaN);
  set('topology', flags.has('Prune') || flags.has('Permissive') ? 'free' : 'keep', NaN);
  if (flags.has('Regularize')) set('valence', '', 1);
  if (flags.has('RegularizeLight')) set('valence', '', 0.2);
}

function checkAttributes(positions, stride, attributes, attributeStride, weights, lock) {
  const n = positions.length / stride;
  check(attributes instanceof Float32Array);
  check(attributes.length === attributeStride * n);
  check(attributeStride >= 0);
  check(lock == null || lock instanceof Uint8Array);
  check(lock == null || lock.length === n);
  check(Array.isArray(weights));
  check(attributeStride >= weights.length);
  check(weights.length <= 32);
  for (const weight of weights) check(weight >= 0);
}

/** Those parts whose bounding box has a diagonal of at least `size`. */
function withoutSmallParts(indices, positions, stride, size) {
  const mesh = {positions: packed(positions, stride), indices: Uint32Array.from(indices)};
  // As many faces as there are: nothing is contracted.
  const kept = simplify(mesh, {prune: size, facesLeft: Math.max(1, indices.length / 3), effort: 'fast', polish: 0});
  const result = new Uint32Array(3 * kept.faceOrigins.length);
  kept.faceOrigins.forEach((face, i) => result.set(indices.subarray(3 * face, 3 * face + 3), 3 * i));
  return result;
}

function absent(name, instead) {
  return () => {
    throw new WhittleError(`${name} has no equivalent in Whittle: ${instead}`);
  };
}

/** meshoptimizer's interface; docs/user/from-meshoptimizer-js.md has what differs. */
export const MeshoptSimplifier = {
  ready,
  supported: typeof WebAssembly === 'object',

  compactMesh(indices) {
    checkIndices(indices);
    const n = indices.reduce((most, v) => Math.max(most, v), 0) + 1;
    const remap = new Uint32Array(n).fill(0xffffffff);
    let unique = 0;
    for (let i = 0; i < indices.length; ++i) {
      if (remap[indices[i]] === 0xffffffff) remap[indices[i]] = unique++;
      indices[i] = remap[indices[i]];
    }
    return [remap, unique];
  },

  generatePositionRemap(positions, stride) {
    checkPositions(positions, stride);
    const first = new Map();
    const remap = new Uint32Array(positions.length / stride);
    for (let v = 0; v < remap.length; ++v) {
      const at = v * stride;
      const key = `${positions[at] + 0},${positions[at + 1] + 0},${positions[at + 2] + 0}`;
      if (!first.has(key)) first.set(key, v);
      remap[v] = first.get(key);
    }
    return remap;
  },

  simplify(indices, positions, stride, count, error, flags) {
    checkIndices(indices);
    checkPositions(positions, stride);
    checkTarget(indices, count, error);
    return overVertices(indices, positions, stride, null, count, error, flagsOf(flags));
  },

  simplifyWithAttributes(indices, positions, stride, attributes, attributeStride, weights, lock, count, error, flags) {
    checkIndices(indices);
    checkPositions(positions, stride);
    checkAttributes(positions, stride, attributes, attributeStride, weights, lock);
    checkTarget(indices, count, error);
    return overVertices(indices, positions, stride, lock, count, error, flagsOf(flags));
  },

  simplifyWithUpdate: absent('simplifyWithUpdate', 'simplify moves vertices and fits attributes to them'),

  simplifySloppy: absent('simplifySloppy', "simplify with topology: 'free' and a threshold joins parts"),

  simplifyPoints: absent('simplifyPoints', 'it simplifies triangles only'),

  remesh: absent('remesh', 'it keeps the triangles of the input'),

  simplifyPrune(indices, positions, stride, error) {
    checkIndices(indices);
    checkPositions(positions, stride);
    check(error >= 0);
    if (indices.length === 0) return indices.slice();
    const result = withoutSmallParts(indices, positions, stride, error * getScale(positions, stride));
    return indices instanceof Uint32Array ? result : new indices.constructor(result);
  },

  getScale,
};
