#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Pairs of faces of a simplified mesh that are of one part, have no common corner, and intersect, though nothing did
/// there in the mesh it was made from: two walls of a thin part, say, that have come to cross. Faces intersect as in
/// `self_intersections`; corners at equal positions are common ones. Parts are those of `find_parts`; for intersections
/// of two parts see `newly_meeting_parts`.
///
/// The faces that became a face are those with a vertex that became one of its corners. A pair is new if none of the
/// faces that became the one intersects any that became the other.
/// \param vertex_map of each vertex of `before` the one of `after` that it became, or `invalid_index`
/// \param threads 0 = all cores; the result is the same for any number
/// \return each as (lower, higher) face of `after`, ascending
/// \throw std::invalid_argument as `bounds` for `after`, and for `before` where faces of `after` intersect; also for a
/// map of another length than the vertices of `before` or with numbers out of range.
std::vector<std::array<Index, 2>> newly_crossing_faces(const IndexedMesh& before, const IndexedMesh& after,
                                                       std::span<const Index> vertex_map, unsigned threads = 0);

}  // namespace whittle::metrics
