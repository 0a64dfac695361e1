#include "surface_walk.hh"

#include <algorithm>
#include <array>

namespace whittle {
namespace {

/// More than enough where the start is near.
constexpr std::size_t most_steps = 48;

/// Barycentric coordinates.
struct Place {
  double second, third;
};

/// The point of the triangle nearest to the origin. \cite ericson_2005_collision (section 5.1.5)
Place nearest_to_origin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double over_c = d1 * d4 - d3 * d2;
  if (over_c <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double over_b = d5 * d2 - d1 * d6;
  if (over_b <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double over_a = d3 * d6 - d5 * d4;
  if (over_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double third = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - third, third};
  }
  const double sum = over_a + over_b + over_c;
  return {over_b / sum, over_c / sum};
}

}  // namespace

NearestPoint walk_to_nearest(const Surface& surface, const Sample& sample, double least_agreement) {
  const auto& [faces, corners, positions] = surface;
  std::array<Index, most_steps> seen;
  std::size_t n_seen = 0;
  NearestPoint nearest;
  for (Index v = sample.start; v != invalid_index && n_seen < most_steps;) {
    seen[n_seen++] = v;
    const Vec3 a = positions[v] - sample.position;
    for (const Corner& corner : corners.of(v)) {
      const Vec3 b = positions[corner_after(faces[corner.face], corner.place, 1)] - sample.position;
      const Vec3 c = positions[corner_after(faces[corner.face], corner.place, 2)] - sample.position;
      const Vec3 normal = (b - a).cross(c - a);
      if (!(normal.dot(sample.normal) > least_agreement * normal.norm())) continue;
      const auto [next, last] = nearest_to_origin(a, b, c);
      const double distance_sq = (a + next * (b - a) + last * (c - a)).squaredNorm();
      if (distance_sq < nearest.distance_sq) nearest = {&corner, next, last, distance_sq};
    }
    v = invalid_index;
    if (nearest.corner == nullptr) break;
    const std::array<double, 3> weights{1 - nearest.next - nearest.last, nearest.next, nearest.last};
    double most = 0;
    for (Index i = 0; i < 3; ++i) {
      const Index u = corner_after(faces[nearest.corner->face], nearest.corner->place, i);
      if (!(weights[i] > most) || std::find(seen.begin(), seen.begin() + n_seen, u) != seen.begin() + n_seen) continue;
      most = weights[i];
      v = u;
    }
  }
  return nearest;
}

}  // namespace whittle
