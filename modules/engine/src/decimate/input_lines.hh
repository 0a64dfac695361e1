#pragma once

#include "complex/restraints.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Ascending, lower vertex first.
struct InputEdges {
  std::vector<VertexPair> features;  ///< by angle, and those that the caller names, which may be no edges of the mesh
  std::vector<VertexPair> seams;     ///< those that are no features
};
InputEdges input_edges(const IndexedMesh& mesh, const DecimateOptions& options);
/// The same with rims of two-sided sheets (`held_rims`) among the features: along the sheet the surface holds no vertex
/// of them in place.
InputEdges input_edges_with_rims(const IndexedMesh& mesh, const DecimateOptions& options);
/// The features alone.
std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options);

struct InputLines {
  FeatureLines held;              ///< the features (`InputEdges`), and the seams if they are kept
  std::vector<VertexPair> seams;  ///< those that are no features, whether they are kept or not; ascending
};
/// \param keeps_seams whether vertices on seams go along them only
InputLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_seams);

}  // namespace whittle
