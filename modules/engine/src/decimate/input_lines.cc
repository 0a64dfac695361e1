#include "decimate/input_lines.hh"

#include <algorithm>
#include <utility>

#include "whittle/core/feature_edges.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// By angle, and those that the caller names. Ascending.
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

}  // namespace

FeatureLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options) {
  FeatureLines lines;
  const std::vector<VertexPair> features = input_features(mesh, options);
  const std::vector<VertexPair> seams = seam_edges(mesh);
  std::set_union(features.begin(), features.end(), seams.begin(), seams.end(), std::back_inserter(lines.edges));
  if (seams.empty()) return lines;
  for (const VertexPair& edge : lines.edges) {
    lines.is_seam.push_back(static_cast<std::uint8_t>(!std::binary_search(features.begin(), features.end(), edge)));
  }
  return lines;
}

}  // namespace whittle
