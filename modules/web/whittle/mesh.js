// Meshes as arrays: into the module, and out of it.
import {WhittleError} from './errors.js';
import {writeText} from './options.js';

// In the order of AttributeKind.
const kinds = ['texcoord', 'normal', 'tangent', 'color', 'joints', 'morph', 'direction', 'scalar', 'category'];

const floats = (array) => (array instanceof Float64Array ? Float64Array : Float32Array);

function checkArray(array, name, length, what) {
  if (!(Array.isArray(array) || (ArrayBuffer.isView(array) && !(array instanceof DataView)))) {
    throw new WhittleError(`${name} is no array of numbers`);
  }
  if (array.length !== length) throw new WhittleError(`${name} has ${array.length} numbers, not ${length}: ${what}`);
}

/** Attributes of a mesh in one form: the short names `texcoords` and `colors` are attributes, too. */
function attributesOf(mesh, n) {
  const all = [];
  if (mesh.texcoords) all.push({name: 'texcoords', kind: 'texcoord', itemSize: 2, values: mesh.texcoords});
  if (mesh.colors) all.push({name: 'colors', kind: 'color', itemSize: mesh.colors.length / n, values: mesh.colors});
  for (const [name, given] of Object.entries(mesh.attributes ?? {})) {
    const attribute = Array.isArray(given) || ArrayBuffer.isView(given) ? {values: given} : given;
    const itemSize = attribute.itemSize ?? attribute.values.length / n;
    all.push({name, kind: attribute.kind ?? 'scalar', itemSize, values: attribute.values});
  }
  for (const {name, kind, itemSize, values} of all) {
    if (!kinds.includes(kind)) throw new WhittleError(`${name}: '${kind}' is none of ${kinds.join(', ')}`);
    if (!(Number.isInteger(itemSize) && itemSize > 0))
      throw new WhittleError(`${name}: itemSize is no whole number above 0`);
    checkArray(values, name, itemSize * n, `${itemSize} for each of ${n} vertices`);
  }
  return all;
}

/** Fills the module's arrays. \return what the result needs of the mesh */
export function writeMesh(engine, mesh, tellsProgress) {
  if (typeof mesh !== 'object' || mesh === null) throw new WhittleError('the mesh is no object with positions');
  const {positions, indices, normals, faceGroups, locked} = mesh;
  const n = positions?.length / 3;
  checkArray(positions, 'positions', Math.floor(n) * 3, 'three for each vertex');
  const nIndices = indices?.length ?? n;
  if (indices !== undefined) checkArray(indices, 'indices', Math.floor(nIndices / 3) * 3, 'three for each face');
  else if (n % 3 !== 0) throw new WhittleError(`positions: ${n} vertices without indices make no whole faces`);
  const attributes = attributesOf(mesh, n);
  if (normals) checkArray(normals, 'normals', 3 * n, 'three for each vertex');
  if (faceGroups) checkArray(faceGroups, 'faceGroups', nIndices / 3, 'one for each face');
  if (locked) checkArray(locked, 'locked', n, 'one for each vertex');
  engine.begin(n, nIndices / 3, tellsProgress ? 1 : 0);
  const put = (Type, at, values) => new Type(engine.memory.buffer, at, values.length).set(values);
  put(Float64Array, engine.positions(), positions);
  const corners = new Uint32Array(engine.memory.buffer, engine.faces(), nIndices);
  if (indices) corners.set(indices);
  else for (let i = 0; i < nIndices; ++i) corners[i] = i;
  for (const {name, kind, itemSize, values} of attributes) {
    writeText(engine, engine.name_of, name);
    const at = engine.attribute(kinds.indexOf(kind), itemSize);
    put(Float64Array, at, values);
  }
  if (normals) put(Float32Array, engine.normals(), normals);
  if (locked) put(Uint8Array, engine.locked(), locked);
  if (faceGroups) {
    const nGroups = faceGroups.reduce((most, group) => Math.max(most, group + 1), 0);
    put(Uint32Array, engine.groups(nGroups), faceGroups);
  }
  return {attributes, positions, hasGroups: Boolean(faceGroups), given: mesh};
}

/** Copies of the arrays of the i-th result, of the types that were given. */
export function readMesh(engine, written, i) {
  const n = engine.result_size(i);
  const nFaces = engine.result_n_faces(i);
  const copy = (Type, Target, at, length) => new Target(new Type(engine.memory.buffer, at, length));
  const result = {
    positions: copy(Float64Array, floats(written.positions), engine.result_positions(i), 3 * n),
    indices: copy(Uint32Array, Uint32Array, engine.result_faces(i), 3 * nFaces),
    origins: copy(Uint32Array, Uint32Array, engine.result_origins(i), n),
  };
  const normals = engine.result_normals(i);
  if (normals !== 0) result.normals = copy(Float32Array, Float32Array, normals, 3 * n);
  if (written.hasGroups) result.faceGroups = copy(Uint32Array, Uint32Array, engine.result_groups(i), nFaces);
  written.attributes.forEach(({name, kind, itemSize, values}, which) => {
    const array = copy(Float64Array, floats(values), engine.result_attribute(i, which), itemSize * n);
    if (written.given[name] === values) result[name] = array;
    else (result.attributes ??= {})[name] = {values: array, itemSize, kind};
  });
  return result;
}
