#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Flags each face that has the same vertices in the same cyclic order as an earlier one. Degenerate faces are never
/// flagged. \param vertices more than the largest number in `faces`. \param threads 0 = all cores
std::vector<char> find_duplicate_faces(std::span<const Triangle> faces, std::size_t vertices, unsigned threads);

}  // namespace whittle::io
