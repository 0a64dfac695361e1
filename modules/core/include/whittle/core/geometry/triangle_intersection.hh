#pragma once

#include <array>
#include <span>

#include "whittle/core/geometry/triangle.hh"

namespace whittle::detail {

/// Whether two triangles intersect by more than rounding errors. Touching is not intersecting, and a triangle without
/// area (`reliable_normal`) intersects nothing.
bool intersect(const Corners& s, const Corners& t);
inline bool intersect(const Triangle& s, const Triangle& t, std::span<const Vec3> positions) {
  return intersect(corners_of(positions, s), corners_of(positions, t));
}

/// Whether two faces intersect now, but not before, each with itself as it was. `metrics::newly_crossing_faces`
/// compares meshes whose faces have no counterpart. \param before, after the corners of both
inline bool intersect_newly(const std::array<Corners, 2>& before, const std::array<Corners, 2>& after) {
  return intersect(after[0], after[1]) && !intersect(before[0], before[1]);
}

}  // namespace whittle::detail
