#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Pairs of parts of a simplified mesh that intersect, but didn't in the original. Parts are numbered as by
/// `find_parts` of `after`. Parts intersect as in `self_intersections`: touching counts. Takes O(F) time if no part is
/// near another.
/// \param vertex_map for each vertex of `before` its vertex in `after`, or `invalid_index`
/// \param threads 0 = all cores; the result is the same for any number
/// \return pairs (lower, higher) of parts, ascending
/// \throw std::invalid_argument as `bounds` for `after`, and for `before` where parts of `after` intersect; also if the
///        map's length isn't the number of vertices of `before`, or its numbers are out of range.
std::vector<std::array<Index, 2>> newly_meeting_parts(const IndexedMesh& before, const IndexedMesh& after,
                                                      std::span<const Index> vertex_map, unsigned threads = 0);

}  // namespace whittle::metrics
