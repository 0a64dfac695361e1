#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Pairs of parts of a simplified mesh that intersect, though they didn't in the mesh it was made from. Parts are
/// numbered as by `find_parts` of `after`. Parts intersect as in `self_intersections`: touching counts. Where no part
/// comes near another this takes O(F) time.
/// \param vertex_map of each vertex of `before` the one of `after` that it became, or `invalid_index`
/// \param threads 0 = all cores; the result is the same for any number
/// \return each as (lower, higher) number, ascending
/// \throw std::invalid_argument as `bounds` for `after`, and for `before` where parts of `after` intersect; also for a
/// map of another length than the vertices of `before` or with numbers out of range.
std::vector<std::array<Index, 2>> newly_meeting_parts(const IndexedMesh& before, const IndexedMesh& after,
                                                      std::span<const Index> vertex_map, unsigned threads = 0);

}  // namespace whittle::metrics
