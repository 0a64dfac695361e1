#pragma once

#include <span>

#include "whittle/core/geometry/triangle.hh"

namespace whittle::detail {

/// Whether two triangles intersect by more than rounding errors. Touching is not intersecting.
bool intersect(const Corners& s, const Corners& t);
inline bool intersect(const Triangle& s, const Triangle& t, std::span<const Vec3> positions) {
  return intersect(corners_of(positions, s), corners_of(positions, t));
}

}  // namespace whittle::detail
