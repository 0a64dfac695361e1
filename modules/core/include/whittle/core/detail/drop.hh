#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Drops faces and vertices from a mesh, with their attributes. The others keep their order.

namespace whittle {

/// \pre `to` is at most `from`
inline void copy_value(Attribute& attribute, std::size_t from, std::size_t to) {
  const std::span<const double> value = std::as_const(attribute).value(from);
  std::copy(value.begin(), value.end(), attribute.value(to).begin());
}

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
      for (std::size_t c = 0; c < 3 && !mesh.wedges.empty(); ++c) mesh.wedges[3 * kept + c] = mesh.wedges[3 * f + c];
      for (Attribute& attribute : mesh.face_attributes) copy_value(attribute, f, kept);
    }
    ++kept;
  }
  mesh.faces.resize(kept);
  if (!mesh.face_groups.empty()) mesh.face_groups.resize(kept);
  if (!mesh.wedges.empty()) mesh.wedges.resize(3 * kept);
  for (Attribute& attribute : mesh.face_attributes) attribute.values.resize(kept * attribute.n_components);
  return count - kept;
}

/// Drops the vertices for which `is_dropped(v)` holds. Their attributes go with them, except in a table of wedges
/// (`join_equal_wedges` drops unused wedges). If any vertex is dropped, `origins` is filled.
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
  compact(mesh.origins);
  if (mesh.wedges.empty()) {
    compact(mesh.normals);
    compact(mesh.colors);
    for (Attribute& attribute : mesh.attributes) {
      for (std::size_t v = 0; v < count; ++v) {
        if (renumbered[v] != invalid_index) copy_value(attribute, v, renumbered[v]);
      }
      attribute.values.resize(kept * attribute.n_components);
    }
  }
  for (Triangle& face : mesh.faces) {
    for (Index& v : face) v = renumbered[v];
  }
  return renumbered;
}

}  // namespace whittle
