#pragma once

#include <Eigen/Geometry>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Moves a mesh by an affine map: positions, normals, tangents, and what morph targets add to each (to tangents as if
/// it were added to normals, which is the same unless the map stretches one way more than another). Normals and
/// tangents get unit length, but for those of length zero. A map that mirrors turns faces over, so that their fronts
/// stay fronts.
void transform_mesh(IndexedMesh& mesh, const Eigen::Affine3d& map);

}  // namespace whittle
