#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// The edges where a surface is sharp: those of exactly two faces whose normals differ by more than `angle_deg`,
/// however the faces are oriented to each other's sides. Faces without area have no normal, and make none.
/// \param angle_deg degrees, [0, 180]
/// \return each with its lower vertex first, ascending
/// \throw std::invalid_argument for an angle out of range, or a face that names a vertex that isn't there
std::vector<VertexPair> feature_edges(const IndexedMesh& mesh, double angle_deg);

}  // namespace whittle
