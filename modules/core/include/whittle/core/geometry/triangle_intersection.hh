#pragma once

#include <array>
#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// Whether two triangles intersect by more than rounding errors. Touching is not intersecting.
bool intersect(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);
inline bool intersect(const Triangle& s, const Triangle& t, std::span<const Vec3> positions) {
  return intersect({positions[s[0]], positions[s[1]], positions[s[2]]},
                   {positions[t[0]], positions[t[1]], positions[t[2]]});
}

}  // namespace whittle::detail
