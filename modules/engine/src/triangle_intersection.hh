#pragma once

#include <array>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// Whether two triangles intersect by more than rounding; to touch is not to intersect.
bool intersect(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t);

}  // namespace whittle
