#include "guard/border_motion.hh"

#include <algorithm>
#include <limits>

#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle {

/// Infinite if there are none.
double BorderMotion::distance_sq_to(const Edges& edges, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& edge : edges) least = std::min(least, distance_to(edge, point));
  return least * least;
}

}  // namespace whittle
