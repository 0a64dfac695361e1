#include <algorithm>
#include <utility>

#include "decimate/staged_run.hh"
#include "loop/contraction_log.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/attributes.hh"

namespace whittle {
namespace {

SurfaceCounts surface_counts(std::size_t n_components, const NonmanifoldCounts& nonmanifold) {
  return {n_components, nonmanifold.edges, nonmanifold.vertices};
}

/// Parts of the input of which no vertex is left.
std::size_t count_vanished(const Parts& parts, const std::vector<Index>& vertex_map) {
  std::vector<bool> is_left(parts.count);
  for (std::size_t v = 0; v < vertex_map.size(); ++v) {
    if (vertex_map[v] != invalid_index) is_left[parts.part_of[v]] = true;
  }
  return static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), false));
}

/// Fills in components and non-manifold counts of the surface before and after.
void compare_surfaces(const IndexedMesh& input, const NonmanifoldCounts& before, const NonmanifoldCounts& after,
                      bool keeps_parts, Decimation& out) {
  out.result.after = surface_counts(find_parts(out.mesh.positions.size(), out.mesh.faces).count, after);
  out.result.before = surface_counts(out.result.after.components, before);
  const bool is_manifold = before.edges == 0 && before.vertices == 0;
  if (keeps_parts && is_manifold) return;
  const Parts parts = find_parts(input.positions.size(), input.faces);
  out.result.before.components = parts.count;
  out.result.n_vanished_components = count_vanished(parts, out.vertex_map);
}

std::vector<Warning> warnings_about(const ThresholdPairCounts& pairs) {
  std::vector<Warning> warnings;
  if (pairs.capped) {
    warnings.push_back({WarningKind::pairs_capped,
                        "some vertices had more threshold pairs than max_pairs; the nearest "
                        "were taken"});
  }
  return warnings;
}

}  // namespace

Decimation geometry_of(const IndexedMesh& input, WorkingSurface left, const Frame& frame) {
  Decimation out;
  IndexedMesh& mesh = out.mesh;
  mesh.positions = std::move(left.positions.own());
  mesh.origins = std::move(left.origins);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Index& v = mesh.origins[i];
    mesh.positions[i] = to_output(mesh.positions[i], input.positions[v], frame);
    if (!input.origins.empty()) v = input.origins[v];
  }
  mesh.faces = std::move(left.faces.own());
  out.face_origins = std::move(left.face_origins);
  out.vertex_map = std::move(left.vertex_map);
  out.feature_edges = std::move(left.lines.edges);
  out.quadrics = std::move(left.quadrics);
  return out;
}

Decimation StagedRun::finish(bool keeps_in_charts) {
  const NonmanifoldCounts nonmanifold = surface().nonmanifold ? *surface().nonmanifold : count_nonmanifold(surface());
  Decimation out = geometry_of(mesh_, std::move(state_.surface), frame_);
  if (options_.keep_steps) {
    out.steps = std::move(report().steps);
    if (options_.normals == Normals::recompute) out.steps.crease_angle_deg = options_.crease_angle_deg;
  }
  carry_attributes(mesh_, frame_, options_.normals, out.vertex_map, out.face_origins, out.mesh, options_.threads,
                   keeps_in_charts);
  out.result = std::move(report().result);
  for (const auto& [pair, reason] : report().refused_pairs) {
    const auto [a, b] = std::minmax(out.vertex_map[pair.a], out.vertex_map[pair.b]);
    if (b != invalid_index) out.refused_pairs.push_back({{a, b}, reason});
  }
  out.result.warnings = warnings_about(out.result.threshold_pairs);
  const bool keeps_parts = topology() == Topology::keep && !(options_.pairs.threshold > 0);
  compare_surfaces(mesh_, *nonmanifold_before_, nonmanifold, keeps_parts, out);
  return out;
}

}  // namespace whittle
