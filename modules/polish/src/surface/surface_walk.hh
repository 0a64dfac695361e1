#pragma once

#include <limits>
#include <span>

#include "surface/vertex_corners.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::polishing {

/// A mesh with its vertices at some positions.
struct Surface {
  std::span<const Triangle> faces;
  const VertexCorners& corners;
  std::span<const Vec3> positions;
};

/// The point of a surface that is nearest to some point.
struct NearestPoint {
  Index face = invalid_index;  ///< `invalid_index` if no face was found
  Barycentric at{0, 0};        ///< in the face
  double distance_sq = std::numeric_limits<double>::infinity();
};

/// The nearest to a point of some vertices; the first of equally near ones.
struct NearestVertex {
  Vec3 point;
  Index vertex = invalid_index;
  double distance_sq = std::numeric_limits<double>::infinity();

  void look_at(Index v, const Vec3& position) {
    const double square = (position - point).squaredNorm();
    if (!(square < distance_sq)) return;
    distance_sq = square;
    vertex = v;
  }
};

/// The point nearest to `point` that a walk over a surface finds. Each step looks at the faces at one vertex, first at
/// `start`. The next vertex is the corner of the nearest face so far with the largest barycentric coordinate, of those
/// not visited yet.
/// \param faces_at_vertex for each vertex its faces
NearestPoint walk_to_nearest(std::span<const Triangle> faces, const detail::IndexLists<Index>& faces_at_vertex,
                             std::span<const Vec3> positions, const Vec3& point, Index start);
NearestPoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start);

}  // namespace whittle::polishing
