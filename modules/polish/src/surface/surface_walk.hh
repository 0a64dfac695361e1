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

/// A point on a surface, and its squared distance from the point it was searched for.
struct SurfacePoint {
  Index face = invalid_index;  ///< `invalid_index` if no face was found
  Barycentric at{0, 0};        ///< in the face
  double distance_sq = std::numeric_limits<double>::infinity();
};

/// Finds the vertex nearest to a point; the first of equally near ones.
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

/// The closest point to `point` that a walk over a surface finds. Each step looks at the faces at one vertex, first at
/// `start`. The next vertex is the unvisited corner of the nearest face so far with the largest barycentric coordinate.
/// \param faces_at_vertex the faces at each vertex
SurfacePoint walk_to_nearest(std::span<const Triangle> faces, const detail::IndexLists<Index>& faces_at_vertex,
                             std::span<const Vec3> positions, const Vec3& point, Index start);
SurfacePoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start);

}  // namespace whittle::polishing
