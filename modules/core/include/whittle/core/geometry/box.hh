#pragma once

#include <Eigen/Geometry>
#include <span>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A closed axis-aligned box. It is empty until it is extended by a point or a box.
using Box = Eigen::AlignedBox3d;
/// A box for searches: rounding to single precision keeps overlapping boxes overlapping.
using FloatBox = Eigen::AlignedBox3f;

/// \pre not empty
inline Vec3 center_of(const Box& box) { return box.min() + 0.5 * (box.max() - box.min()); }

/// Length of a box' diagonal; 0 if the box is empty.
inline double diagonal_of(const Box& box) {
  if (box.isEmpty()) return 0;
  const Vec3 size = box.sizes();
  return detail::hypotenuse(size.x(), detail::hypotenuse(size.y(), size.z()));
}

/// The box around points. Without points, a box of no extent at the origin.
inline Box bounds_of(std::span<const Vec3> points) {
  if (points.empty()) return Box(Vec3::Zero());
  Box box;
  for (const Vec3& p : points) box.extend(p);
  return box;
}
inline double diagonal_of(std::span<const Vec3> points) { return diagonal_of(bounds_of(points)); }

}  // namespace whittle
