#pragma once

#include <algorithm>
#include <cmath>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// The nearest of 0…255 for an intensity of 0…1.
inline unsigned to_byte(float intensity) {
  return intensity > 0 ? static_cast<unsigned>(std::lround(std::min(intensity, 1.0F) * 255.0F)) : 0U;
}

/// Whether some colour is not opaque.
inline bool has_opacity(const IndexedMesh& mesh) {
  return std::any_of(mesh.colors.begin(), mesh.colors.end(), [](const Color& c) { return c[3] != 1; });
}

}  // namespace whittle::io
