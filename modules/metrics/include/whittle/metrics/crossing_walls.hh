#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Pairs of faces of a simplified mesh in one part, without a common corner, that intersect although the original
/// didn't there: for example, walls of a thin part that now cross. Faces intersect as in `self_intersections`; corners
/// at equal positions are common. Parts come from `find_parts`; for intersections of two parts see
/// `newly_meeting_parts`.
///
/// The origins of a face are the original faces with a vertex that became one of its corners. A pair is new if no
/// origin of one face intersects an origin of the other.
/// \param vertex_map for each vertex of `before` its vertex in `after`, or `invalid_index`
/// \param threads 0 = all cores; the result is the same for any number
/// \return pairs (lower, higher) of faces of `after`, ascending
/// \throw std::invalid_argument as `bounds_of` for `after`, and for the origins of faces that intersect; also if the
///        map's length isn't the number of vertices of `before`, or its numbers are out of range.
std::vector<std::array<Index, 2>> newly_crossing_faces(const IndexedMesh& before, const IndexedMesh& after,
                                                       std::span<const Index> vertex_map, unsigned threads = 0);

}  // namespace whittle::metrics
