#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Flags each face that has the same vertices in the same cyclic order as an earlier one. Degenerate faces are never
/// flagged. \param vertices more than the largest number in `faces`.
std::vector<char> find_duplicate_faces(const std::vector<Triangle>& faces, std::size_t vertices);

}  // namespace whittle::io
