// Simplifies a mesh of Babylon.js: its vertex data in, and out.
import {VertexData} from '@babylonjs/core/Meshes/mesh.vertexData.js';
import {simplifyInWorker} from 'whittle-mesh';

/** Replaces the geometry of a mesh. \param options those of `simplify`, such as {faceRatio: 0.1} */
export async function simplifyMesh(mesh, options, control) {
  const before = VertexData.ExtractFromMesh(mesh);
  const {positions, indices, normals, uvs, colors} = before;
  // Babylon.js' faces are clockwise where its axes are left-handed: the order of corners stays as it is.
  const small = await simplifyInWorker(
    {
      positions: Float32Array.from(positions),
      indices: Uint32Array.from(indices),
      normals: normals ? Float32Array.from(normals) : undefined,
      texcoords: uvs ? Float32Array.from(uvs) : undefined,
      colors: colors ? Float32Array.from(colors) : undefined,
    },
    options,
    control,
  );
  const after = new VertexData();
  after.positions = small.positions;
  after.indices = small.indices;
  after.normals = small.normals ?? null;
  after.uvs = small.texcoords ?? null;
  after.colors = small.colors ?? null;
  after.applyToMesh(mesh);
  return small.report;
}
