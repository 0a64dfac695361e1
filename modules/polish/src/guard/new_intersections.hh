#pragma once

#include "guard/face_limits.hh"
#include "surface/surface_walk.hh"

namespace whittle {

/// Puts vertices of a mesh that were moved back to where they were, until no two faces intersect that didn't before.
/// Faces that share an edge only do when they are folded onto each other; taking back turns no faces over, or to their
/// neighbours more than is allowed.
/// \param before the mesh and where its vertices were
/// \param positions where they are now
/// \param taken_back vertices that have been put back already
void take_back_intersections(const Surface& before, const FaceLimits& limits, std::vector<Vec3>& positions,
                             std::span<const Index> taken_back, unsigned threads);

}  // namespace whittle
