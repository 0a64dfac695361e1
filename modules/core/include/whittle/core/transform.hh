#pragma once

#include <Eigen/Geometry>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Transforms a mesh by an affine map: positions, normals, tangents, and the offsets of morph targets to them. Offsets
/// to tangents are transformed like offsets to normals; the two differ only if the map stretches directions unequally.
/// Normals and tangents get unit length, unless they are zero. A mirroring map turns faces over, so that their fronts
/// stay fronts.
void transform_mesh(IndexedMesh& mesh, const Eigen::Affine3d& map);

}  // namespace whittle
