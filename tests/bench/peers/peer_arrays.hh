#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// What several peers need to convert the arrays to their own form and back.

namespace whittle::bench {

/// The vertices that some face uses, in the same order; attributes are dropped.
inline IndexedMesh without_unused_vertices(const IndexedMesh& mesh) {
  std::vector<Index> number(mesh.positions.size(), invalid_index);
  for (const Triangle& face : mesh.faces)
    for (const Index v : face) number[v] = 0;
  IndexedMesh result;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == invalid_index) continue;
    number[v] = static_cast<Index>(result.positions.size());
    result.positions.push_back(mesh.positions[v]);
  }
  for (const auto& [a, b, c] : mesh.faces) result.faces.push_back({number[a], number[b], number[c]});
  return result;
}

/// \throw std::runtime_error unless n is 0, for meshes that a half-edge structure can't hold
inline void require_none_refused(std::size_t n_refused, std::size_t n_faces) {
  if (n_refused == 0) return;
  throw std::runtime_error("it can't hold " + std::to_string(n_refused) + " of the " + std::to_string(n_faces) +
                           " faces");
}

}  // namespace whittle::bench
