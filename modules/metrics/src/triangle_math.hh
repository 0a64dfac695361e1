#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// The normal (b − a) × (c − a), as long as twice the area. Zero if the triangle's height is below 1e-11 of its longest
/// side: then rounding may turn the normal about that side by more than 3e-6, and each point of the triangle is within
/// 5e-12 of a side. The normal is perpendicular to the longest side up to rounding, however thin the triangle is.
inline Vec3 trusted_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> sides{b - a, c - b, a - c};
  std::size_t k = 0;
  for (const std::size_t i : {1U, 2U}) {
    if (sides[i].squaredNorm() > sides[k].squaredNorm()) k = i;
  }
  const Vec3 &longest = sides[k], &next = sides[(k + 1) % 3], &last = sides[(k + 2) % 3];
  // The product of the two shorter sides has the least rounding error. Its part along the longest side is rounding
  // error, which would tilt the plane where the triangle is longest, so it is removed.
  const double longest_sq = longest.squaredNorm();
  Vec3 normal = next.cross(last);
  if (!(normal.norm() > 1e-11 * longest_sq)) return Vec3::Zero();
  return normal - (normal.dot(longest) / longest_sq) * longest;
}

/// The point of a segment, whose ends may coincide, that is nearest to a point.
inline Vec3 nearest_on_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double t = (point - from).dot(along), end = along.squaredNorm();
  if (!(t > 0.0)) return from;
  if (t >= end) return to;
  return from + (t / end) * along;
}

}  // namespace whittle::metrics
