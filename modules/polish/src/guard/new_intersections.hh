#pragma once

#include "guard/face_limits.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Moves vertices back until no two faces newly intersect. Faces with a common edge are not compared: they intersect
/// only as folds, which `FaceLimits` forbids. Faces that moving back turns or thins beyond the limits go back, too.
/// \param before the mesh before the moves
/// \param positions current positions
/// \param taken_back vertices that are back already
/// \throw Cancelled
void take_back_intersections(const Surface& before, const FaceLimits& limits, std::vector<Vec3>& positions,
                             std::span<const Index> taken_back, const detail::Workers& workers);

}  // namespace whittle::polishing
