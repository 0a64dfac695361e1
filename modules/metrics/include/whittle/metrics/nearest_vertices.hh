#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"

namespace whittle::metrics {

/// For each vertex of `from` a vertex of `to` near it on the surface: the nearest corner of the nearest face of `to`;
/// `invalid_index` for a vertex without a face. A substitute for an unknown vertex map in `polish`.
/// \param threads 0 = all cores; the result is the same for any number.
/// \throw std::invalid_argument as `bounds`.
/// \throw Cancelled if `progress` returned false.
std::vector<Index> nearest_vertices(const IndexedMesh& from, const IndexedMesh& to, unsigned threads = 0,
                                    const ProgressCallback& progress = {});

}  // namespace whittle::metrics
