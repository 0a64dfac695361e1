#pragma once

#include <vector>

#include "whittle/io/repair.hh"

namespace whittle::io {

/// `weld_borders`, but if that would lay copies of a face together, all copies of faces in the mesh are dropped first:
/// faces at the positions of an earlier face in the same cyclic order; vertices may differ.
Repairs weld_borders_without_copies(IndexedMesh& mesh, std::vector<Index>* joined_to, unsigned threads);

/// Drops the faces that welding made degenerate or duplicate, and isolated vertices. Adds the counts to `done`, the
/// counts of welding; welded vertices don't count as isolated. \return as `drop_vertices`
std::vector<Index> tidy_after_welding(IndexedMesh& mesh, Repairs& done, unsigned threads);

}  // namespace whittle::io
