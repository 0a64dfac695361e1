// Geometries of three.js.
import {BufferAttribute, BufferGeometry} from 'three';
import {WhittleError} from './errors.js';
import {simplifyInWorker} from './in_worker.js';
import {simplify} from './simplify.js';

const kindOf = {uv: 'texcoord', uv1: 'texcoord', uv2: 'texcoord', uv3: 'texcoord', tangent: 'tangent', color: 'color'};
const skin = 'skinIndex+skinWeight';

/** All numbers of an attribute, interleaved or not; normalized ones as the reals that they stand for. */
function numbersOf(attribute) {
  const {count, itemSize} = attribute;
  const numbers = new Float64Array(count * itemSize);
  for (let v = 0; v < count; ++v)
    for (let i = 0; i < itemSize; ++i) numbers[v * itemSize + i] = attribute.getComponent(v, i);
  return numbers;
}

/** An attribute of the same type, normalized if that one is. */
function likeThat(attribute, numbers) {
  const Type = attribute.isInterleavedBufferAttribute ? attribute.data.array.constructor : attribute.array.constructor;
  const made = new BufferAttribute(new Type(numbers.length), attribute.itemSize, attribute.normalized);
  for (let v = 0; v < made.count; ++v) {
    for (let i = 0; i < made.itemSize; ++i) made.setComponent(v, i, numbers[v * made.itemSize + i]);
  }
  return made;
}

function checkGeometry(geometry) {
  if (!geometry?.isBufferGeometry) throw new WhittleError('simplifyGeometry takes a BufferGeometry');
  if (!geometry.attributes.position) throw new WhittleError('the geometry has no positions');
  if (geometry.isInstancedBufferGeometry)
    throw new WhittleError('simplify the geometry of the instances, not an InstancedBufferGeometry');
  if (geometry.drawRange.start !== 0 || geometry.drawRange.count !== Infinity) {
    throw new WhittleError('the geometry has a drawRange: set it to all before');
  }
}

/** Group of each face; faces in no group get the number after the last. */
function groupsOf(geometry, nFaces) {
  if (geometry.groups.length === 0) return undefined;
  const groups = new Uint32Array(nFaces).fill(geometry.groups.length);
  geometry.groups.forEach(({start, count}, i) =>
    groups.fill(i, Math.ceil(start / 3), Math.floor(Math.min(start + count, 3 * nFaces) / 3)),
  );
  return groups;
}

function addMorphs(geometry, attributes) {
  const base = numbersOf(geometry.attributes.position);
  for (const [name, targets] of Object.entries(geometry.morphAttributes)) {
    targets.forEach((target, i) => {
      const values = numbersOf(target);
      if (!geometry.morphTargetsRelative && name !== 'color') {
        const from = name === 'position' ? base : numbersOf(geometry.attributes[name]);
        for (let k = 0; k < values.length; ++k) values[k] -= from[k];
      }
      const kind = name === 'position' ? 'morph' : name === 'normal' ? 'direction' : 'scalar';
      attributes[`morph:${name}:${i}`] = {values, itemSize: target.itemSize, kind};
    });
  }
}

function toMesh(geometry) {
  const {position, normal, skinIndex, skinWeight} = geometry.attributes;
  const attributes = {};
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (['position', 'normal', 'skinIndex', 'skinWeight'].includes(name)) continue;
    attributes[name] = {values: numbersOf(attribute), itemSize: attribute.itemSize, kind: kindOf[name] ?? 'scalar'};
  }
  if (skinIndex && skinWeight) {
    const [joints, weights] = [numbersOf(skinIndex), numbersOf(skinWeight)];
    const values = new Float64Array(8 * position.count);
    for (let v = 0; v < position.count; ++v) {
      const sum = weights[4 * v] + weights[4 * v + 1] + weights[4 * v + 2] + weights[4 * v + 3] || 1;
      for (let i = 0; i < 4; ++i) {
        values[8 * v + i] = joints[4 * v + i];
        values[8 * v + 4 + i] = weights[4 * v + i] / sum;
      }
    }
    attributes[skin] = {values, itemSize: 8, kind: 'joints'};
  }
  addMorphs(geometry, attributes);
  const nFaces = (geometry.index?.count ?? position.count) / 3;
  return {
    positions: numbersOf(position),
    indices: geometry.index ? Uint32Array.from(geometry.index.array) : undefined,
    normals: normal ? Float32Array.from(numbersOf(normal)) : undefined,
    attributes,
    faceGroups: groupsOf(geometry, nFaces),
  };
}

/** Faces by group, and the groups as ranges of them. */
function setFaces(small, input, output) {
  const {indices, faceGroups} = small;
  const Type = small.positions.length / 3 <= 65535 ? Uint16Array : Uint32Array;
  if (!faceGroups) return output.setIndex(new BufferAttribute(Type.from(indices), 1));
  const sorted = new Type(indices.length);
  let at = 0;
  for (let group = 0; group <= input.groups.length; ++group) {
    const start = at;
    faceGroups.forEach((of, face) => {
      if (of !== group) return;
      sorted.set(indices.subarray(3 * face, 3 * face + 3), at);
      at += 3;
    });
    if (at > start && group < input.groups.length)
      output.addGroup(start, at - start, input.groups[group].materialIndex);
  }
  return output.setIndex(new BufferAttribute(sorted, 1));
}

function setSkin({values}, input, output) {
  const n = values.length / 8;
  const [joints, weights] = [new Float64Array(4 * n), new Float64Array(4 * n)];
  for (let v = 0; v < n; ++v) {
    joints.set(values.subarray(8 * v, 8 * v + 4), 4 * v);
    weights.set(values.subarray(8 * v + 4, 8 * v + 8), 4 * v);
  }
  output.setAttribute('skinIndex', likeThat(input.attributes.skinIndex, joints));
  output.setAttribute('skinWeight', likeThat(input.attributes.skinWeight, weights));
}

function setMorph(name, {values}, small, input, output) {
  const [, of, number] = name.split(':');
  if (!input.morphTargetsRelative && of !== 'color') {
    const base = of === 'position' ? small.positions : small.normals;
    for (let k = 0; k < values.length; ++k) values[k] += base[k];
  }
  (output.morphAttributes[of] ??= [])[number] = likeThat(input.morphAttributes[of][number], values);
}

function toGeometry(small, input) {
  const output = new BufferGeometry();
  output.name = input.name;
  output.userData = input.userData;
  output.morphTargetsRelative = input.morphTargetsRelative;
  output.setAttribute('position', likeThat(input.attributes.position, small.positions));
  if (small.normals) output.setAttribute('normal', likeThat(input.attributes.normal, small.normals));
  for (const [name, attribute] of Object.entries(small.attributes ?? {})) {
    if (name === skin) setSkin(attribute, input, output);
    else if (name.startsWith('morph:')) setMorph(name, attribute, small, input, output);
    else output.setAttribute(name, likeThat(input.attributes[name], attribute.values));
  }
  setFaces(small, input, output);
  return output;
}

/** A simplified copy of a geometry: three.d.ts has the details. */
export function simplifyGeometry(geometry, options) {
  checkGeometry(geometry);
  return toGeometry(simplify(toMesh(geometry), options), geometry);
}

/** The same on another thread. */
export async function simplifyGeometryInWorker(geometry, options, control) {
  checkGeometry(geometry);
  return toGeometry(await simplifyInWorker(toMesh(geometry), options, control), geometry);
}
