#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Two-sided sheets: surfaces of which each face is there twice, with opposite orientation, on the same three vertices.
// So modellers write them that show the outside of faces alone.

namespace whittle {

/// Finds two-sided sheets. Two faces on the same three vertices, with opposite orientation, are a pair; of three faces
/// or more no two are. A sheet is a set of pairs, connected over edges:
/// - of two pairs at least: two faces that close a pocket are none;
/// - that is no wall between bodies: a wall has two faces or more beside its own at each edge where it ends.
///
/// \return F; for the later face of each pair of a sheet, its *back*, the number of the other, its *front*; for all
///         others `invalid_index`. Empty if there is no sheet. Nearly linear time; little where no faces coincide
std::vector<Index> fronts_of_backs(std::span<const Triangle> faces);

/// The numbers of all faces but the backs of two-sided sheets, ascending. Nearly linear time.
std::vector<Index> faces_without_backs(std::span<const Triangle> faces);

}  // namespace whittle
