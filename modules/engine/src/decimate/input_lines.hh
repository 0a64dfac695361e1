#pragma once

#include "complex/restraints.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

struct InputLines {
  /// The feature edges by angle and those that the caller names, and the seams if they are kept. Some that the caller
  /// names may be no edges of the mesh.
  FeatureLines held;
  std::vector<VertexPair> seams;  ///< those that are no features, whether they are kept or not; ascending
};
/// \param keeps_seams whether vertices on seams go along them only
InputLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_seams);

/// The edges of `InputLines::held`, without a host.
std::vector<VertexPair> held_edges(const IndexedMesh& mesh, const DecimateOptions& options);

}  // namespace whittle
