#pragma once

#include <span>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// The parts of a mesh: sets of faces connected over vertices.
struct Parts {
  std::size_t count = 0;
  std::vector<Index> part_of;  ///< by vertex, numbered from 0 by their lowest vertices; `invalid_index` without a face
};

/// Faces with two equal corners don't count. O(V + F). \pre the faces' vertex numbers are below `n_vertices`.
Parts find_parts(std::size_t n_vertices, std::span<const Triangle> faces);

}  // namespace whittle
