#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Drops faces and vertices from a mesh, with their attributes. The others keep their order.

namespace whittle {

/// Drops the faces for which `is_dropped(f)` holds, with their attributes. \return the number dropped.
template <class Predicate>
std::size_t drop_faces(IndexedMesh& mesh, const Predicate& is_dropped) {
  const std::size_t count = mesh.faces.size();
  std::size_t kept = 0;
  for (std::size_t f = 0; f < count; ++f) {
    if (is_dropped(f)) continue;
    if (kept != f) {
      mesh.faces[kept] = mesh.faces[f];
      if (!mesh.face_groups.empty()) mesh.face_groups[kept] = mesh.face_groups[f];
      for (std::size_t c = 0; c < 3 && !mesh.corner_texcoords.empty(); ++c) {
        mesh.corner_texcoords[3 * kept + c] = mesh.corner_texcoords[3 * f + c];
      }
    }
    ++kept;
  }
  mesh.faces.resize(kept);
  if (!mesh.face_groups.empty()) mesh.face_groups.resize(kept);
  if (!mesh.corner_texcoords.empty()) mesh.corner_texcoords.resize(3 * kept);
  return count - kept;
}

/// Drops the vertices for which `is_dropped(v)` holds, with their attributes. If any is dropped, `origins` is filled.
/// \pre no face has a dropped vertex
/// \return V; the new number of each vertex, `invalid_index` if it was dropped
template <class Predicate>
std::vector<Index> drop_vertices(IndexedMesh& mesh, const Predicate& is_dropped) {
  const std::size_t count = mesh.positions.size();
  std::vector<Index> renumbered(count, invalid_index);
  Index kept = 0;
  for (std::size_t v = 0; v < count; ++v) {
    if (!is_dropped(v)) renumbered[v] = kept++;
  }
  if (kept == count) return renumbered;
  if (mesh.origins.empty()) {
    mesh.origins.resize(count);
    std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
  }
  const auto compact = [&](auto& values) {
    if (values.empty()) return;
    for (std::size_t v = 0; v < count; ++v) {
      if (renumbered[v] != invalid_index) values[renumbered[v]] = values[v];
    }
    values.resize(kept);
  };
  compact(mesh.positions);
  compact(mesh.normals);
  compact(mesh.colors);
  compact(mesh.origins);
  for (Triangle& face : mesh.faces) {
    for (Index& v : face) v = renumbered[v];
  }
  return renumbered;
}

}  // namespace whittle
