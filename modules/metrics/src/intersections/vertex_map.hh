#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// \param vertex_map of each vertex of `before` the one of `after` that it became, or `invalid_index`
/// \throw std::invalid_argument for another length than the vertices of `before`, and for numbers out of range
void check_vertex_map(std::span<const Index> vertex_map, const IndexedMesh& before, const IndexedMesh& after);

}  // namespace whittle::metrics
