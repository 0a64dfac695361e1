#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Makes several vertices one, with a wedge for each where their attributes differ. Faces stay.
/// \param joined V; for each vertex the one that it becomes, which is none after it and becomes itself
/// \pre the mesh has origins \return V; their new numbers
std::vector<Index> join_vertices(IndexedMesh& mesh, std::span<const Index> joined);

}  // namespace whittle
