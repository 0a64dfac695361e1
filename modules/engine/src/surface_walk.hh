#pragma once

#include <limits>
#include <span>

#include "vertex_corners.hh"

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

/// A point of another surface.
struct Sample {
  Vec3 position;
  Vec3 normal;  ///< of unit length, or zero
  Index start;  ///< a vertex of the surface near it
};

/// Where a surface is nearest to a point.
struct NearestPoint {
  const Corner* corner = nullptr;  ///< of that face, none if no face was met
  double next = 0;                 ///< barycentric coordinate of the corner after it
  double last = 0;                 ///< and of the one after that
  double distance_sq = std::numeric_limits<double>::infinity();
};

/// The nearest point met on the way over the surface: from the faces at one vertex to those at that corner of the
/// nearest face so far which has most of the point and was not passed yet.
/// \param least_agreement cosine that a face's normal and the sample's must have; faces with a smaller one don't count
NearestPoint walk_to_nearest(const Surface& surface, const Sample& sample, double least_agreement);

}  // namespace whittle
