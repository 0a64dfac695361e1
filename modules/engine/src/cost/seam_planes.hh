#pragma once

#include <span>
#include <vector>

#include "cost/cost_state.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// The planes that hold seams (`Seams`) and the fold edges of two-sided sheets (`fold_edges`): for each such edge and
/// each of its faces the one through the edge, perpendicular to the face, as border edges have. Those of folds have the
/// weight of borders. They belong to both ends of the edge. \param seams, folds lower vertex first, ascending \return
/// their sums by vertex, ascending, in the frame
std::vector<VertexQuadric> seam_planes(const IndexedMesh& mesh, const Frame& frame, std::span<const VertexPair> seams,
                                       std::span<const VertexPair> folds, const DecimateOptions& options);

}  // namespace whittle
