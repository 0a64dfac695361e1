#pragma once

#include <span>
#include <stdexcept>
#include <string>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// \throw std::invalid_argument if a face names a vertex that isn't there.
inline void check_corners(std::size_t n_vertices, std::span<const Triangle> faces) {
  for (const Triangle& face : faces) {
    for (const Index v : face) {
      if (v < n_vertices) continue;
      throw std::invalid_argument("face " + std::to_string(&face - faces.data()) + " names vertex " +
                                  std::to_string(v) + " of " + std::to_string(n_vertices));
    }
  }
}

}  // namespace whittle
