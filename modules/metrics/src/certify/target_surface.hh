#pragma once

#include <array>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/metrics/closest_point.hh"

namespace whittle::metrics {

/// What rounding may do to a distance, with room: lengths are about 1. Proofs hold with this to spare.
inline constexpr double slack = 1e-14;

/// A triangle by its corners.
using Corners = std::array<Vec3, 3>;

/// The surface that triangles are proven to be near to: in a frame of about the size 1.
class TargetSurface {
 public:
  /// \param meter is told the progress, and may cancel \throw Cancelled
  TargetSurface(const IndexedMesh& mesh, const Frame& frame, whittle::detail::ProgressMeter& meter);

  Corners corners(Index face) const {
    const auto& [a, b, c] = mesh_.faces[face];
    return {mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]};
  }
  /// The other face at the side from corner `slot` to the next, or `invalid_index` if there is not exactly one.
  Index beyond(Index face, std::size_t slot) const { return beyond_[face][slot]; }

  ClosestPoint nearest(const Vec3& point, Index hint) const { return tree_.nearest_local(point, hint); }

 private:
  IndexedMesh mesh_;  ///< in the frame
  std::vector<std::array<Index, 3>> beyond_;
  TriangleTree tree_;
};

/// Distance of a point from a triangle, or more by rounding errors of 1e-15. Its corners may coincide.
double distance_to(const Corners& triangle, const Vec3& point);

}  // namespace whittle::metrics
