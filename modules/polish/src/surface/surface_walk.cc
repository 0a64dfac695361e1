#include "surface/surface_walk.hh"

#include <algorithm>
#include <array>

namespace whittle::polishing {
namespace {

/// Limit for a walk; far fewer steps are enough from a start that is near.
constexpr std::size_t most_vertices = 48;

Index face_of(Index face) { return face; }
Index face_of(const Corner& corner) { return corner.face; }

template <class Lists>
SurfacePoint walk(std::span<const Triangle> faces, const Lists& at_vertex, std::span<const Vec3> positions,
                  const Vec3& point, Index start) {
  std::array<Index, most_vertices> seen;
  std::size_t n_seen = 0;
  SurfacePoint nearest;
  for (Index v = start; v != invalid_index && n_seen < most_vertices;) {
    seen[n_seen++] = v;
    for (const auto& item : at_vertex.of(v)) {
      const Index f = face_of(item);
      const Vec3 a = positions[faces[f][0]] - point;
      const Vec3 b = positions[faces[f][1]] - point;
      const Vec3 c = positions[faces[f][2]] - point;
      const Vec3 normal = area_normal(a, b, c);
      const double square = normal.squaredNorm();
      if (!(square > 0)) continue;
      const double above = normal.dot(a);
      if (above * above > nearest.distance_sq * square) continue;  // its plane is already too far
      const Barycentric at = nearest_on_triangle(a, b, c);
      const double distance_sq = point_at({a, b, c}, at).squaredNorm();
      if (distance_sq < nearest.distance_sq) nearest = {f, at, distance_sq};
    }
    v = invalid_index;
    if (nearest.face == invalid_index) break;
    const std::array<double, 3> weights{1 - nearest.at.second - nearest.at.third, nearest.at.second, nearest.at.third};
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = faces[nearest.face][i];
      if (!(weights[i] > most) || std::find(seen.begin(), seen.begin() + n_seen, u) != seen.begin() + n_seen) continue;
      most = weights[i];
      v = u;
    }
  }
  return nearest;
}

}  // namespace

SurfacePoint walk_to_nearest(std::span<const Triangle> faces, const detail::IndexLists<Index>& faces_at_vertex,
                             std::span<const Vec3> positions, const Vec3& point, Index start) {
  return walk(faces, faces_at_vertex, positions, point, start);
}

SurfacePoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start) {
  return walk(surface.faces, surface.corners, surface.positions, point, start);
}

}  // namespace whittle::polishing
