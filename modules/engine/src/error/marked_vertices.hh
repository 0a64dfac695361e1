#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Some vertices of a mesh, a 1 each.

namespace whittle {

inline std::vector<std::uint8_t> marked_vertices(std::span<const Index> vertices, std::size_t n_vertices) {
  std::vector<std::uint8_t> marked(n_vertices);
  for (const Index v : vertices) marked[v] = 1;
  return marked;
}

/// Those that are marked, and those that have a face in common with one.
inline std::vector<std::uint8_t> with_neighbours(const std::vector<std::uint8_t>& marked,
                                                 std::span<const Triangle> faces) {
  std::vector<std::uint8_t> wider = marked;
  for (const auto& [a, b, c] : faces) {
    if ((marked[a] | marked[b] | marked[c]) != 0) wider[a] = wider[b] = wider[c] = 1;
  }
  return wider;
}

}  // namespace whittle
