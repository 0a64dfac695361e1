#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// For each vertex of `from` a vertex of `to` near it on the surface: of the face of `to` that is nearest, the corner
/// that is. `invalid_index` for a vertex in no face. What `polish` takes where no map is known.
/// \param threads 0 = all cores; the result doesn't depend on it. \throw std::invalid_argument as `bounds`.
std::vector<Index> nearest_vertices(const IndexedMesh& from, const IndexedMesh& to, unsigned threads = 0);

}  // namespace whittle::metrics
