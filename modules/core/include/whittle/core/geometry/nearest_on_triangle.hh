#pragma once

#include "whittle/core/geometry/triangle.hh"

namespace whittle {

/// Barycentric coordinates in a triangle. The first one is 1 minus the others.
struct Barycentric {
  double second, third;
};

inline Vec3 point_at(const Corners& corners, const Barycentric& at) {
  const auto& [a, b, c] = corners;
  return a + at.second * (b - a) + at.third * (c - a);
}

/// The point of the triangle nearest to the origin. NaN if two corners coincide. \cite ericson_2005_collision (section
/// 5.1.5)
inline Barycentric nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
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

/// Squared distance from the origin. NaN if two corners coincide.
inline double distance_sq_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return point_at({a, b, c}, nearest_on_triangle(a, b, c)).squaredNorm();
}

}  // namespace whittle
