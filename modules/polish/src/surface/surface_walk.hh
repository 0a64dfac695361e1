#pragma once

#include <limits>
#include <span>

#include "whittle/core/detail/vertex_corners.hh"

namespace whittle {

/// A mesh, and where its vertices are.
struct Surface {
  std::span<const Triangle> faces;
  const VertexCorners& corners;
  std::span<const Vec3> positions;
};

/// As long as twice the face's area.
inline Vec3 area_normal(const Triangle& face, std::span<const Vec3> positions) {
  const Vec3& corner = positions[face[0]];
  return (positions[face[1]] - corner).cross(positions[face[2]] - corner);
}

/// Where a surface is nearest to a point.
struct NearestPoint {
  const Corner* corner = nullptr;  ///< of that face, none if no face was met
  double next = 0;                 ///< barycentric coordinate of the corner after it
  double last = 0;                 ///< and of the one after that
  double distance_sq = std::numeric_limits<double>::infinity();
};

/// The point nearest to `point` that is met on the way over the surface: from the faces at one vertex, first `start`,
/// to those at that corner of the nearest face so far which has most of the point and was not passed yet.
NearestPoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start);

}  // namespace whittle
