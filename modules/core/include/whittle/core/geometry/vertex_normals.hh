#pragma once

#include <array>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Unit normals of vertices: the normalised sum of their faces' normals, weighted by area.
std::vector<std::array<float, 3>> vertex_normals(const IndexedMesh& mesh, const Frame& frame);

}  // namespace whittle
