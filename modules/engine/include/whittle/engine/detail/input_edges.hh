#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/options.hh"

namespace whittle::detail {

/// Ascending, lower vertex first.
struct InputEdges {
  std::vector<VertexPair> features;  ///< by angle, and those that the caller names, which may be no edges of the mesh
  std::vector<VertexPair> seams;     ///< those that are no features
};

/// The feature edges and the seams of a mesh. Fold edges of two-sided sheets (`DecimateOptions::hold_folds`) count as
/// features here, but not in a run: along the sheet the surface holds no vertex of them in place.
InputEdges input_edges_with_rims(const IndexedMesh& mesh, const DecimateOptions& options);

}  // namespace whittle::detail
