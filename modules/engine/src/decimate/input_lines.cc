#include "decimate/input_lines.hh"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cost/fold_edges.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/detail/input_edges.hh"

namespace whittle {

using detail::InputEdges;

std::vector<VertexPair> input_features(const IndexedMesh& mesh, const DecimateOptions& options) {
  std::vector<VertexPair> edges;
  const double angle_deg = options.feature_angle_deg.value_or(180);
  if (angle_deg < 180) edges = feature_edges(mesh, angle_deg);
  for (const auto& [a, b] : options.feature_edges) edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

namespace {

InputEdges input_edges(const IndexedMesh& mesh, const DecimateOptions& options) {
  InputEdges edges{input_features(mesh, options), {}};
  const std::vector<VertexPair> seams = seam_edges(mesh, face_regions(mesh, options.regions));
  std::set_difference(seams.begin(), seams.end(), edges.features.begin(), edges.features.end(),
                      std::back_inserter(edges.seams));
  return edges;
}

}  // namespace

InputEdges detail::input_edges_with_rims(const IndexedMesh& mesh, const DecimateOptions& options) {
  InputEdges edges = input_edges(mesh, options);
  const std::vector<VertexPair> folds = held_folds(mesh, Frame::of_points(mesh.positions), options);
  if (folds.empty()) return edges;
  InputEdges all;
  std::set_union(edges.features.begin(), edges.features.end(), folds.begin(), folds.end(),
                 std::back_inserter(all.features));
  std::set_difference(edges.seams.begin(), edges.seams.end(), folds.begin(), folds.end(),
                      std::back_inserter(all.seams));
  return all;
}

InputLines input_lines(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_seams) {
  InputLines lines;
  InputEdges input = input_edges(mesh, options);
  lines.seams = std::move(input.seams);
  std::vector<VertexPair>& edges = lines.held.edges;
  edges = std::move(input.features);
  if (lines.seams.empty() || !keeps_seams) return lines;
  std::vector<VertexPair> all;
  std::set_union(edges.begin(), edges.end(), lines.seams.begin(), lines.seams.end(), std::back_inserter(all));
  edges = std::move(all);
  for (const VertexPair& edge : edges) {
    const bool is_seam = std::binary_search(lines.seams.begin(), lines.seams.end(), edge);
    lines.held.is_seam.push_back(static_cast<std::uint8_t>(is_seam));
  }
  return lines;
}

}  // namespace whittle
