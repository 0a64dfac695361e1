#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle::metrics {

/// The normal (b − a) × (c − a), twice the area long; zero when the triangle's height is below 1e-10 of its longest
/// side. There rounding would turn the normal by more than about 1e-6, and what lies between the sides is closer to
/// them than any distance here is good for.
inline Vec3 trusted_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double ab_sq = ab.squaredNorm(), bc_sq = bc.squaredNorm(), ca_sq = ca.squaredNorm();
  const double longest_sq = std::max({ab_sq, bc_sq, ca_sq});
  // The product of the two shorter sides has the least rounding error.
  Vec3 normal;
  if (longest_sq == ab_sq) {
    normal = bc.cross(ca);
  } else if (longest_sq == bc_sq) {
    normal = ca.cross(ab);
  } else {
    normal = ab.cross(bc);
  }
  if (!(normal.norm() > 1e-10 * longest_sq)) return Vec3::Zero();
  return normal;
}

}  // namespace whittle::metrics
