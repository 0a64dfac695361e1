#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// \throw std::invalid_argument if a face names a vertex that isn't there.
inline void check_indices(const IndexedMesh& mesh) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      if (v < mesh.positions.size()) continue;
      throw std::invalid_argument("face " + std::to_string(f) + " uses vertex " + std::to_string(v) + " of " +
                                  std::to_string(mesh.positions.size()));
    }
  }
}

}  // namespace whittle::metrics
