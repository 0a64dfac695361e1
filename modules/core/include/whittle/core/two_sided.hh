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
/// \param threads 0 = all cores
std::vector<Index> fronts_of_backs(const IndexedMesh& mesh, unsigned threads = 0);

/// Numbers of all faces except the backs of two-sided sheets, ascending. Nearly linear time.
std::vector<Index> faces_without_backs(const IndexedMesh& mesh, unsigned threads = 0);

/// All faces that have their three vertices in common with another one, in any order, and few others; ascending. Faces
/// with two equal corners are left out. \param threads 0 = all cores
std::vector<Index> faces_that_may_coincide(std::span<const Triangle> faces, std::size_t n_vertices,
                                           unsigned threads = 0);

}  // namespace whittle
