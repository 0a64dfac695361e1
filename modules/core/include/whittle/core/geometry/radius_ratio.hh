#pragma once

#include <cmath>

#include "whittle/core/geometry/triangle.hh"

namespace whittle {

/// The quality of a triangle: twice the radius of its inscribed circle over the radius of its circumscribed circle,
/// 16 area² / (perimeter · product of the edges). [0, 1]; 1 is equilateral, 0 without area.
inline double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = (b - a).norm();
  const double bc = (c - b).norm();
  const double ca = (a - c).norm();
  const double product = ab * bc * ca;
  if (!(product > 0)) return 0;
  return 4 * area_normal(a, b, c).squaredNorm() / (product * (ab + bc + ca));
}

}  // namespace whittle
