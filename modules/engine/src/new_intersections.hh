#pragma once

#include "face_neighbors.hh"
#include "surface_walk.hh"

namespace whittle {

/// Puts vertices of a mesh that were moved back to where they were, until no two faces intersect that didn't before.
/// Faces that share an edge only do when they are folded onto each other; taking back makes no folds, nor does it turn
/// faces over.
/// \param before the mesh and where its vertices were
/// \param positions where they are now
void take_back_intersections(const Surface& before, const FaceNeighbors& neighbors, std::vector<Vec3>& positions,
                             unsigned threads);

}  // namespace whittle
