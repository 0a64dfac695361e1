#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Two-sided sheets: surfaces that have each face twice, with opposite orientation, on the same three vertices.
// Modellers that only draw the outside of faces write them.

namespace whittle {

/// Finds two-sided sheets. Two faces on the same three vertices, with opposite orientation, are a pair; three or more
/// faces have no pair. A sheet is a set of pairs, connected over edges:
/// - at least two pairs: two faces that close a pocket are no sheet;
/// - no wall between bodies: a wall has two or more other faces at each edge where it ends.
///
/// \return F; for the later face of each pair, its *back*, the number of the earlier face, its *front*; for all other
///         faces `invalid_index`. Empty without sheets. Nearly linear time; little if no faces coincide
std::vector<Index> fronts_of_backs(std::span<const Triangle> faces);

/// Numbers of all faces except the backs of two-sided sheets, ascending. Nearly linear time.
std::vector<Index> faces_without_backs(std::span<const Triangle> faces);

}  // namespace whittle
