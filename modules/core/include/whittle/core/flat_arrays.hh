#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

// Views of a mesh's arrays as plain numbers, without a copy. They are valid as long as the mesh's arrays.

namespace whittle {

/// x, y, z of each vertex in turn: 3 V, model units.
inline std::span<const double> flat_positions(const IndexedMesh& mesh) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (mesh.positions.empty()) return {};
  return {mesh.positions.front().data(), 3 * mesh.positions.size()};
}

/// The three vertices of each face in turn: 3 F.
inline std::span<const Index> flat_faces(const IndexedMesh& mesh) {
  static_assert(sizeof(Triangle) == 3 * sizeof(Index));
  if (mesh.faces.empty()) return {};
  return {mesh.faces.front().data(), 3 * mesh.faces.size()};
}

}  // namespace whittle
