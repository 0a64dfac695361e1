#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// The sharp edges of a surface: edges with exactly two faces whose normals differ by more than `angle_deg`. If both
/// faces run along the edge in the same direction, one of them is reversed first. Edges of faces without area are not
/// sharp.
/// \param angle_deg degrees, [0, 180]
/// \return ascending
/// \throw std::invalid_argument for an angle out of range, or a face with a missing vertex
std::vector<VertexPair> feature_edges(const IndexedMesh& mesh, double angle_deg);

}  // namespace whittle
