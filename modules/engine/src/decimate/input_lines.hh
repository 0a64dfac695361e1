#pragma once

#include "complex/constraints.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// The feature edges of a mesh, as those of `detail::InputEdges`.
std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options);

struct InputLines {
  FeatureLines held;              ///< the features (`input_features`), and the seams if they are kept
  std::vector<VertexPair> seams;  ///< those that are no features, whether they are kept or not; ascending
};
/// \param keeps_seams whether vertices on seams go along them only
InputLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_seams);

}  // namespace whittle
