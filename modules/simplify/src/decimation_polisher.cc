#include "decimation_polisher.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "whittle/core/geometry/box.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// Per vertex of the output, 1 = made from a locked vertex; empty if none is locked.
std::vector<std::uint8_t> locked_outputs(const std::vector<std::uint8_t>& locked, const Decimation& decimation) {
  std::vector<std::uint8_t> result;
  if (locked.empty()) return result;
  result.resize(decimation.mesh.positions.size());
  for (std::size_t v = 0; v < locked.size(); ++v) {
    const Index output = decimation.vertex_map[v];
    if (locked[v] != 0 && output != invalid_index) result[output] = 1;
  }
  return result;
}

/// Passes the progress of polish on to `decimate.progress`. The mesh stays as it is until polish ends.
ProgressCallback polish_progress(const DecimateOptions& decimate, const Decimation& decimation) {
  if (!decimate.progress) return {};
  return [&](const TaskProgress& progress) {
    const auto surface = [&mesh = decimation.mesh] { return without_attributes(mesh); };
    const DecimateResult& result = decimation.result;
    return decimate.progress({result.n_vertices, result.n_faces, progress.fraction, Stage::polish, surface});
  };
}

/// Weight of shape in polish, from the weights in contraction. With isotropy W, polish draws vertices to the middle of
/// their neighbours as much as contraction draws them to the middle of an edge (edge_length_term.hh). Valences give no
/// positions; but polish makes triangles less round, and a tenth of the weight for W = 0.5 compensates for that.
double shape_weight_of(const DecimateOptions& options) {
  constexpr double most = 1000;  // at W = 1 the error doesn't count
  constexpr double of_valences = 0.1;
  const double isotropy = options.isotropy;
  const double by_isotropy = isotropy < 1 ? std::min(most, isotropy / (1 - isotropy)) : most;
  return by_isotropy + of_valences * std::min(1.0, 2 * options.valence_weight);
}

/// Edges of the output that edges of the input became.
std::vector<VertexPair> mapped(const std::vector<VertexPair>& edges, const std::vector<Index>& vertex_map) {
  std::vector<VertexPair> result;
  for (const auto& [a, b] : edges) {
    const auto [low, high] = std::minmax(vertex_map[a], vertex_map[b]);
    if (low != high && high != invalid_index) result.push_back({low, high});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

PolishOptions DecimationPolisher::polish_options(const SimplifyOptions& options, const Decimation& decimation) const {
  const DecimateOptions& decimate = options.decimate;
  PolishOptions result;
  result.passes = *options.polish_passes;
  result.fit = options.fit;
  result.flips = *options.flips;
  result.fit_borders = decimate.boundary != Boundary::locked;
  if (decimate.feature_angle_deg.value_or(180) < 180) result.feature_angle_deg = *decimate.feature_angle_deg;
  if (decimate.min_radius_ratio) result.min_radius_ratio = *decimate.min_radius_ratio;
  result.shape_weight = shape_weight_of(decimate);
  result.recompute_normals = false;  // in the end, after attributes are fitted
  result.threads = decimate.threads;
  result.progress = polish_progress(decimate, decimation);
  result.locked = locked_outputs(decimate.locked, decimation);
  for (const Index f : input_->regions.empty() ? std::vector<Index>{} : decimation.face_origins) {
    result.regions.push_back(input_->regions[f]);
  }
  result.features = mapped(input_->edges.features, decimation.vertex_map);
  result.original_features = input_->edges.features;
  if (std::isfinite(decimate.feature_tolerance)) {
    result.feature_tolerance = decimate.feature_tolerance * input_->diagonal;
  }
  const double seam_weight = decimate.attribute_weights.seam;
  if (!decimate.holds_seams() && seam_weight > 0) result.seam_weight = seam_weight;
  if (decimate.holds_seams() || seam_weight > 0) {
    result.seams = mapped(input_->edges.seams, decimation.vertex_map);
    result.original_seams = input_->edges.seams;
  }
  return result;
}

void DecimationPolisher::prepare(const DecimateOptions& options, const ProgressCallback& progress) {
  PolishOriginal original(mesh_, options.threads, progress);
  input_.emplace(Input{std::move(original), detail::input_edges_with_rims(mesh_, options),
                       face_regions(mesh_, options.regions), diagonal_of(mesh_.positions)});
}

PolishResult DecimationPolisher::polish(const SimplifyOptions& options, Decimation& decimation) {
  if (options.polish_passes == 0U) return {};
  const DecimateOptions& decimate = options.decimate;
  try {
    std::call_once(is_prepared_, [&] { prepare(decimate, polish_progress(decimate, decimation)); });
    return whittle::polish(input_->original, decimation.vertex_map, decimation.mesh,
                           polish_options(options, decimation));
  } catch (const Cancelled&) {
    PolishResult result;
    result.cancelled = true;
    return result;
  }
}

}  // namespace whittle
