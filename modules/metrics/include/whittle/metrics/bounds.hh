#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// An axis-parallel box, in model units.
struct Bounds {
  Vec3 min = Vec3::Zero();
  Vec3 max = Vec3::Zero();

  Vec3 center() const { return min + 0.5 * (max - min); }
  double diagonal() const { return (max - min).norm(); }
};

/// The box around the vertices that have a face.
/// \throw std::invalid_argument if the mesh has no faces, a face names a vertex that isn't there, or a position of a
/// used vertex is not finite or above 3e150.
Bounds bounds(const IndexedMesh& mesh);

}  // namespace whittle::metrics
