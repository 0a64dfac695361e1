#pragma once

#include <limits>
#include <span>

#include "surface/vertex_corners.hh"

namespace whittle::polishing {

/// A mesh with its vertices at some positions.
struct Surface {
  std::span<const Triangle> faces;
  const VertexCorners& corners;
  std::span<const Vec3> positions;
};

/// The normal of a face, as long as twice its area.
inline Vec3 area_normal(const Triangle& face, std::span<const Vec3> positions) {
  const Vec3& corner = positions[face[0]];
  return (positions[face[1]] - corner).cross(positions[face[2]] - corner);
}

/// The point of a surface that is nearest to some point.
struct NearestPoint {
  const Corner* corner = nullptr;  ///< a corner of its face; null if no face was found
  double next = 0;                 ///< barycentric coordinate of the corner after that one
  double last = 0;                 ///< barycentric coordinate of the third corner
  double distance_sq = std::numeric_limits<double>::infinity();
};

/// The point nearest to `point` that a walk over the surface finds. Each step looks at the faces at one vertex, first
/// at `start`. The next vertex is the corner of the nearest face so far with the largest barycentric coordinate, of
/// those not visited yet.
NearestPoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start);

}  // namespace whittle::polishing
