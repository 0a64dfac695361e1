#include "decimate/input_features.hh"

#include <algorithm>

#include "whittle/core/feature_edges.hh"

namespace whittle {

std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options) {
  std::vector<VertexPair> edges;
  const double angle_deg = options.feature_angle_deg.value_or(180);
  if (angle_deg < 180) edges = feature_edges(mesh, angle_deg);
  for (const auto& [a, b] : options.feature_edges) {
    if (std::max(a, b) < mesh.positions.size()) edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace whittle
