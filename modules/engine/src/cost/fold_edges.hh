#pragma once

#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Fold edges of two-sided sheets: edges whose two faces lie on each other, front and back, as around a leaf. The
/// planes of the faces hold nothing there. Lower vertex first, ascending. Takes O(F) time where no vertex has faces
/// with opposite normals.
std::vector<VertexPair> fold_edges(const IndexedMesh& mesh, const Frame& frame, unsigned threads);

/// Those that planes hold, with the weight of borders: none if the options don't ask for it, or borders have no weight.
inline std::vector<VertexPair> held_folds(const IndexedMesh& mesh, const Frame& frame, const DecimateOptions& options) {
  if (!options.hold_folds.value_or(false) || options.quadric.boundary_weight == 0 || options.boundary == Boundary::free)
    return {};
  return fold_edges(mesh, frame, options.threads);
}

}  // namespace whittle
