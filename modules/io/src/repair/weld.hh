#pragma once

#include <vector>

#include "whittle/io/repair.hh"

namespace whittle::io {

/// As `weld_borders`. But where that would lay copies of a face together, all copies of faces in the mesh are dropped
/// first: faces at equal positions in the same cyclic order as an earlier one, whatever their vertices.
Repairs weld_borders_without_copies(IndexedMesh& mesh, std::vector<Index>* joined_to, unsigned threads);

/// Drops the faces that welding made degenerate or duplicate, and isolated vertices. Adds the counts to `done`, those
/// of welding; welded vertices don't count as isolated. \return as `drop_vertices`
std::vector<Index> tidy_after_welding(IndexedMesh& mesh, Repairs& done, unsigned threads);

}  // namespace whittle::io
