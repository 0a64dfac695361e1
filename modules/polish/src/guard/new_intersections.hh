#pragma once

#include "guard/face_limits.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Puts moved vertices back to where they were, until no two faces intersect that didn't before. Faces with a common
/// edge are not compared: they intersect only as folds, which `FaceLimits` forbids. No face is left that putting back
/// has turned or thinned in a forbidden way. \param before the mesh, and where its vertices were \param positions where
/// the vertices are now \param taken_back vertices that have been put back already \throw Cancelled
void take_back_intersections(const Surface& before, const FaceLimits& limits, std::vector<Vec3>& positions,
                             std::span<const Index> taken_back, const detail::Workers& workers);

}  // namespace whittle::polishing
