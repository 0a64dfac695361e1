#pragma once

#include <cstddef>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::report {

/// What a mesh looks like from afar, in a small part of the time that simplifying it takes: the vertices in a cell of a
/// grid become their mean, and of faces that all fall into two cells nothing is left. Positions and faces alone; a mesh
/// that has few faces keeps all of them. \param most_faces that are left, at least 1
/// \throw std::invalid_argument as `bounds_of`
IndexedMesh rough_level(const IndexedMesh& mesh, std::size_t most_faces);

}  // namespace whittle::report
