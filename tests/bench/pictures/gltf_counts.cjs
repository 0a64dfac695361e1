// Counts the triangles of glTF files.
'use strict';
const fs = require('fs');

function readJson(file) {
  const bytes = fs.readFileSync(file);
  const isBinary = bytes.toString('latin1', 0, 4) === 'glTF';
  return JSON.parse(isBinary ? bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)) : bytes.toString('utf8'));
}

/** Triangles, strips and fans. */
function trianglesOf({accessors}, {mode = 4, indices, attributes}) {
  const {count} = accessors[indices ?? attributes.POSITION];
  return mode === 4 ? Math.floor(count / 3) : mode > 4 ? Math.max(count - 2, 0) : 0;
}

function timesDrawn({accessors}, {extensions}) {
  const instances = extensions?.EXT_mesh_gpu_instancing?.attributes;
  return instances ? accessors[Object.values(instances)[0]].count : 1;
}

/** \return `stored`: each mesh once, as `--faces` and `whittle info` count them; `drawn`: as often as the scene shows it */
function countTriangles(file) {
  const gltf = readJson(file);
  const ofMeshes = (gltf.meshes ?? []).map(({primitives}) =>
    primitives.reduce((sum, primitive) => sum + trianglesOf(gltf, primitive), 0));
  const drawnBelow = (index) => {
    const node = gltf.nodes[index];
    const own = node.mesh === undefined ? 0 : ofMeshes[node.mesh] * timesDrawn(gltf, node);
    return (node.children ?? []).reduce((sum, child) => sum + drawnBelow(child), own);
  };
  const roots = gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? [];
  return {stored: ofMeshes.reduce((a, b) => a + b, 0), drawn: roots.reduce((sum, root) => sum + drawnBelow(root), 0)};
}

module.exports = {countTriangles};
