#pragma once

#include <vector>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle::io {

inline bool is_degenerate(const Triangle& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Flags faces that have the same vertices in the same cyclic order as an earlier one.
/// \param vertices more than the largest number in `faces`. Degenerate faces are never flagged.
std::vector<char> find_duplicate_faces(const std::vector<Triangle>& faces, std::size_t vertices);

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

}  // namespace whittle::io
