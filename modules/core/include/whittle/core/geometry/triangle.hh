#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "whittle/core/geometry/box.hh"

namespace whittle {

using Corners = std::array<Vec3, 3>;

/// Positions of a face's corners.
inline Corners corners_of(std::span<const Vec3> positions, const Triangle& face) {
  return {positions[face[0]], positions[face[1]], positions[face[2]]};
}

/// (b − a) × (c − a): the normal of a triangle, as long as twice its area.
inline Vec3 area_normal(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }
inline Vec3 area_normal(const Corners& corners) { return area_normal(corners[0], corners[1], corners[2]); }
inline Vec3 area_normal(std::span<const Vec3> positions, const Triangle& face) {
  return area_normal(positions[face[0]], positions[face[1]], positions[face[2]]);
}

inline Box box_of(const Corners& corners) {
  const auto& [a, b, c] = corners;
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

inline double area_of(const Corners& corners) { return 0.5 * area_normal(corners).norm(); }
inline double area_of(std::span<const Vec3> positions, const Triangle& face) {
  return 0.5 * area_normal(positions, face).norm();
}

/// `area_normal`, or zero if it is within rounding error: then the triangle has no area and no direction.
inline Vec3 reliable_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double least_sine = 1e-12;
  const Vec3 p = b - a;
  const Vec3 q = c - a;
  Vec3 normal = p.cross(q);
  if (!(normal.squaredNorm() > least_sine * least_sine * p.squaredNorm() * q.squaredNorm())) normal.setZero();
  return normal;
}

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

}  // namespace whittle
