#pragma once

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The normal of a triangle, as long as twice its area. Zero if that is no more than rounding error: the triangle has
/// no area then, and no direction.
inline Vec3 reliable_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double least_sine = 1e-12;
  const Vec3 p = b - a;
  const Vec3 q = c - a;
  Vec3 normal = p.cross(q);
  if (!(normal.squaredNorm() > least_sine * least_sine * p.squaredNorm() * q.squaredNorm())) normal.setZero();
  return normal;
}

}  // namespace whittle
