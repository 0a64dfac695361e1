#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// The feature edges by angle and those that the caller names, ascending; the latter may be no edges of the mesh.
std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options);

}  // namespace whittle
