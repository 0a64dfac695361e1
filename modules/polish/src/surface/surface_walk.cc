#include "surface/surface_walk.hh"

#include <algorithm>
#include <array>

#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle::polishing {
namespace {

/// Limit for a walk; far fewer steps are enough from a start that is near.
constexpr std::size_t most_vertices = 48;

}  // namespace

NearestPoint walk_to_nearest(const Surface& surface, const Vec3& point, Index start) {
  const auto& [faces, corners, positions] = surface;
  std::array<Index, most_vertices> seen;
  std::size_t n_seen = 0;
  NearestPoint nearest;
  for (Index v = start; v != invalid_index && n_seen < most_vertices;) {
    seen[n_seen++] = v;
    const Vec3 a = positions[v] - point;
    for (const Corner& corner : corners.of(v)) {
      const Vec3 b = positions[corner_after(faces[corner.face], corner.slot, 1)] - point;
      const Vec3 c = positions[corner_after(faces[corner.face], corner.slot, 2)] - point;
      const Vec3 normal = (b - a).cross(c - a);
      const double square = normal.squaredNorm();
      if (!(square > 0)) continue;
      const double above = normal.dot(a);
      if (above * above > nearest.distance_sq * square) continue;  // its plane is already too far
      const auto [next, last] = nearest_on_triangle(a, b, c);
      const double distance_sq = (a + next * (b - a) + last * (c - a)).squaredNorm();
      if (distance_sq < nearest.distance_sq) nearest = {&corner, next, last, distance_sq};
    }
    v = invalid_index;
    if (nearest.corner == nullptr) break;
    const std::array<double, 3> weights{1 - nearest.next - nearest.last, nearest.next, nearest.last};
    double most = 0;
    for (Index i = 0; i < 3; ++i) {
      const Index u = corner_after(faces[nearest.corner->face], nearest.corner->slot, i);
      if (!(weights[i] > most) || std::find(seen.begin(), seen.begin() + n_seen, u) != seen.begin() + n_seen) continue;
      most = weights[i];
      v = u;
    }
  }
  return nearest;
}

}  // namespace whittle::polishing
