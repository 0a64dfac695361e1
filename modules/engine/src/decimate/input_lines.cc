#include "decimate/input_lines.hh"

#include <algorithm>
#include <iterator>
#include <utility>

#include "whittle/core/feature_edges.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// By angle, and those that the caller names. Ascending.
std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options) {
  std::vector<VertexPair> edges;
  const double angle_deg = options.feature_angle_deg.value_or(180);
  if (angle_deg < 180) edges = feature_edges(mesh, angle_deg);
  for (const auto& [a, b] : options.feature_edges) edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

InputLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_seams) {
  InputLines lines;
  std::vector<VertexPair>& edges = lines.held.edges;
  edges = input_features(mesh, options);
  const std::vector<VertexPair> seams = seam_edges(mesh, face_regions(mesh, options.regions));
  std::set_difference(seams.begin(), seams.end(), edges.begin(), edges.end(), std::back_inserter(lines.seams));
  if (seams.empty() || !keeps_seams) return lines;
  std::vector<VertexPair> all;
  std::set_union(edges.begin(), edges.end(), seams.begin(), seams.end(), std::back_inserter(all));
  edges = std::move(all);
  for (const VertexPair& edge : edges) {
    const bool is_seam = std::binary_search(lines.seams.begin(), lines.seams.end(), edge);
    lines.held.is_seam.push_back(static_cast<std::uint8_t>(is_seam));
  }
  return lines;
}

std::vector<VertexPair> held_edges(const IndexedMesh& mesh, const DecimateOptions& options) {
  if (!options.holds_seams()) return input_features(mesh, options);
  return input_lines(mesh, options, true).held.edges;
}

}  // namespace whittle
