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

/// Positions in float and indices, as meshoptimizer takes them.
struct FloatArrays {
  std::vector<float> positions;
  std::vector<unsigned> indices;

  explicit FloatArrays(const IndexedMesh& mesh) {
    positions.reserve(3 * mesh.positions.size());
    for (const Vec3& p : mesh.positions)
      for (const double x : p) positions.push_back(static_cast<float>(x));
    indices.reserve(3 * mesh.faces.size());
    for (const Triangle& face : mesh.faces) indices.insert(indices.end(), face.begin(), face.end());
  }
};

/// Faces over the vertices of `mesh`, three indices each.
inline IndexedMesh with_faces(const IndexedMesh& mesh, const std::vector<unsigned>& indices) {
  IndexedMesh result;
  result.positions = mesh.positions;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    result.faces.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return without_unused_vertices(result);
}

/// \throw std::runtime_error unless n is 0, for meshes that a half-edge structure can't hold
inline void require_none_refused(std::size_t n_refused, std::size_t n_faces) {
  if (n_refused == 0) return;
  throw std::runtime_error("it can't hold " + std::to_string(n_refused) + " of the " + std::to_string(n_faces) +
                           " faces");
}

}  // namespace whittle::bench
