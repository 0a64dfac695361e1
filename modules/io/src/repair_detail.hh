#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

inline bool is_degenerate(const Triangle& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Flags faces that have the same vertices in the same cyclic order as an earlier one.
/// \param vertices more than the largest number in `faces`. Degenerate faces are never flagged.
std::vector<char> find_duplicate_faces(const std::vector<Triangle>& faces, std::size_t vertices);

}  // namespace whittle::io
