#pragma once

#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A mesh of faces, and of the vertices that they have.
/// \param n_vertices their numbers are below \param point_of gives the position of a vertex
template <class PointOf>
IndexedMesh surface_of_faces(std::vector<Triangle> faces, std::size_t n_vertices, const PointOf& point_of) {
  IndexedMesh surface;
  std::vector<Index> numbers(n_vertices, invalid_index);
  for (Triangle& face : faces) {
    for (Index& v : face) {
      if (numbers[v] == invalid_index) {
        numbers[v] = static_cast<Index>(surface.positions.size());
        surface.positions.push_back(point_of(v));
      }
      v = numbers[v];
    }
  }
  surface.faces = std::move(faces);
  return surface;
}

}  // namespace whittle
