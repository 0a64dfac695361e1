#include "whittle/polish/polish.hh"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "polisher.hh"
#include "whittle/core/detail/checks.hh"

namespace whittle {
namespace {

void check_edges(std::span<const VertexPair> edges, std::size_t n_vertices) {
  const auto is_known = [n_vertices](const VertexPair& edge) { return std::max(edge.a, edge.b) < n_vertices; };
  if (!std::all_of(edges.begin(), edges.end(), is_known)) {
    throw std::invalid_argument("polish: a feature edge names a vertex that isn't there");
  }
}

void check(const IndexedMesh& original, std::span<const Index> vertex_map, const IndexedMesh& mesh,
           const PolishOptions& options) {
  check_attribute_lengths(mesh, "polish");
  check_positions(original.positions, "polish");
  check_positions(mesh.positions, "polish");
  check_corners(original.positions.size(), original.faces);
  check_corners(mesh.positions.size(), mesh.faces);
  if (vertex_map.size() != original.positions.size()) {
    throw std::invalid_argument("polish: vertex_map has another length than the original's vertices");
  }
  for (const Index v : vertex_map) {
    if (v == invalid_index || v < mesh.positions.size()) continue;
    throw std::invalid_argument("polish: vertex_map names vertex " + std::to_string(v) + " of " +
                                std::to_string(mesh.positions.size()));
  }
  if (!options.locked.empty() && options.locked.size() != mesh.positions.size()) {
    throw std::invalid_argument("polish: locked has another length than the vertices");
  }
  check_edges(options.features, mesh.positions.size());
  check_edges(options.original_features, original.positions.size());
  if (const auto angle = options.feature_angle_deg; angle && !(*angle > 0 && *angle < 180)) {
    throw std::invalid_argument("polish: feature_angle_deg is not in (0, 180)");
  }
  if (const auto ratio = options.min_radius_ratio; ratio && !(*ratio >= 0 && *ratio <= 1)) {
    throw std::invalid_argument("polish: min_radius_ratio is not in [0, 1]");
  }
}

}  // namespace

PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options) {
  check(original, vertex_map, mesh, options);
  PolishResult result;
  if (options.passes == 0 || mesh.faces.empty() || original.faces.empty()) return result;
  detail::ProgressMeter meter(options.progress);
  std::optional<polishing::Polisher> polisher;
  try {
    meter.start("preparing", polishing::run_fraction(0, options));
    polisher.emplace(original, vertex_map, mesh, options, meter);
    result.rms_before = polisher->rms();
    while (result.n_passes < options.passes && polisher->pass()) ++result.n_passes;
    meter.finish();
  } catch (const Cancelled&) {
    result.cancelled = true;
  }
  if (!polisher) return result;
  result.rms_after = polisher->rms();
  if (result.n_passes > 0) result.n_moved = polisher->write(mesh);
  return result;
}

}  // namespace whittle
