#include "whittle/engine/decimate.hh"

#include <algorithm>
#include <memory>
#include <utility>

#include "cost/make_cost.hh"
#include "decimate/checks.hh"
#include "decimate/contraction_loop.hh"
#include "decimate/input_features.hh"
#include "decimate/output.hh"
#include "host/host_cost.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {
namespace {

/// Whether each vertex of the result lies at one of the input.
bool stays_at_vertices(const DecimateOptions& options) {
  const bool has_quadrics = options.effective_cost() == Cost::quadric || options.effective_cost() == Cost::memoryless;
  return has_quadrics && options.quadric.placement == Placement::endpoint;
}

/// Per vertex of the complex; empty if none is.
std::vector<std::uint8_t> locked_vertices(const TriangleComplex& complex, const DecimateOptions& options) {
  std::vector<std::uint8_t> locked;
  if (options.locked.empty() && options.boundary != Boundary::locked) return locked;
  locked.resize(complex.n_vertex_slots());
  for (Index v = 0; v < locked.size(); ++v) {
    const bool by_user = !options.locked.empty() && options.locked[complex.origin(v)] != 0;
    const bool by_border = options.boundary == Boundary::locked && complex.kind(v) != VertexKind::regular;
    locked[v] = by_user || by_border;
  }
  return locked;
}

/// Asks the progress callback between the stages before the first contraction.
class Preparation {
 public:
  explicit Preparation(const DecimateOptions& options) : options_(options) {}

  bool goes_on(std::uint64_t n_vertices, std::uint64_t n_faces) {
    if (goes_on_ && options_.progress) goes_on_ = options_.progress({n_vertices, n_faces, 0});
    return goes_on_;
  }
  /// For tasks before: they throw `Cancelled` where it doesn't go on.
  ProgressCallback task_progress(std::uint64_t n_vertices, std::uint64_t n_faces) {
    if (!options_.progress) return {};
    return [this, n_vertices, n_faces](const TaskProgress&) { return goes_on(n_vertices, n_faces); };
  }

 private:
  const DecimateOptions& options_;
  bool goes_on_ = true;
};

ThresholdPairs threshold_pairs(const IndexedMesh& mesh, const DecimateOptions& options, Preparation& preparation) {
  const auto& [threshold, max_pairs, across_walls] = options.pairs;
  if (!(threshold > 0)) return {};
  try {
    return find_threshold_pairs(mesh.positions, mesh.faces,
                                {*threshold, max_pairs, across_walls, options.threads,
                                 preparation.task_progress(mesh.positions.size(), mesh.faces.size())});
  } catch (const Cancelled&) {
    return {};  // the preparation remembers it
  }
}

ThresholdPairCounts counts_of(const ThresholdPairs& pairs, const DecimateOptions& options) {
  ThresholdPairCounts counts;
  counts.considered = pairs.pairs.size();
  counts.threshold = options.pairs.threshold.value_or(0);
  counts.capped = pairs.capped;
  return counts;
}

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
void compare_surfaces(const IndexedMesh& input, const NonmanifoldCounts& before, TriangleComplex& complex,
                      const DecimateOptions& options, Decimation& out) {
  out.result.after =
      surface_counts(find_parts(out.mesh.positions.size(), out.mesh.faces).count, complex.count_nonmanifold());
  out.result.before = surface_counts(out.result.after.components, before);
  const bool is_manifold = before.edges == 0 && before.vertices == 0;
  const bool has_pairs = options.pairs.threshold > 0;
  if (!has_pairs && options.topology == Topology::keep && is_manifold) return;  // parts stay parts
  const Parts parts = find_parts(input.positions.size(), input.faces);
  out.result.before.components = parts.count;
  out.result.n_vanished_components = count_vanished(parts, out.vertex_map);
}

/// Feature edges of the complex, by vertices of the output, ascending.
std::vector<VertexPair> output_features(const std::vector<VertexPair>& edges, const TriangleComplex& complex,
                                        const std::vector<Index>& vertex_map) {
  std::vector<VertexPair> result;
  for (const auto& [a, b] : edges) {
    const Index first = vertex_map[complex.origin(a)];
    const Index second = vertex_map[complex.origin(b)];
    result.push_back({std::min(first, second), std::max(first, second)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Warning> warnings_about(const IndexedMesh& input, const ThresholdPairCounts& pairs) {
  std::vector<Warning> warnings = warnings_about_attributes(input);
  if (pairs.capped) {
    warnings.push_back({WarningKind::pairs_capped,
                        "some vertices had more threshold pairs than max_pairs; the nearest "
                        "were taken"});
  }
  return warnings;
}

DecimateResult cancelled_at_once(const TriangleComplex& complex) {
  DecimateResult result;
  result.n_vertices = complex.n_vertices();
  result.n_faces = complex.n_faces();
  result.stop = StopReason::cancelled;
  return result;
}

}  // namespace

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::target:
      return "target";
    case StopReason::cost:
      return "cost";
    case StopReason::exhausted:
      return "exhausted";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

namespace {

Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host) {
  check(target, options, mesh.positions.size());
  check(mesh);
  Preparation preparation(options);
  const DecimationState* const state = host ? host->state() : nullptr;
  const Frame frame = state ? state->frame : Frame::of_points(mesh.positions);
  const ThresholdPairs pairs = threshold_pairs(mesh, options, preparation);
  TriangleComplex complex(mesh.positions, mesh.faces, frame, options.threads);
  Restraints restraints;
  if (state) {
    for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
      complex.set_position(v, state->vertices[complex.origin(v)].position);
    }
  }
  std::unique_ptr<PairCost> cost;
  if (HostedCost* const hosted_cost = host ? host->cost() : nullptr) {
    cost = std::make_unique<HostCost>(complex, restraints, *hosted_cost);
  } else {
    cost = make_cost(complex, restraints, options, !pairs.pairs.empty());
  }
  if (host && host->cost() ? host->cost()->stays_at_vertices() : stays_at_vertices(options)) {
    complex.follow_positions();
  }
  cost->see_faces(options.threads);
  complex.connect(pairs.pairs, options.threads);
  cost->start(options.threads);
  if (state) cost->resume(*state);
  const NonmanifoldCounts before = complex.count_nonmanifold();
  restraints = Restraints(complex, locked_vertices(complex, options), input_features(mesh, options),
                          options.feature_angle_deg.value_or(180),
                          options.feature_tolerance * bounds_of(mesh.positions).diagonal() * frame.scale);
  DecimateResult result = preparation.goes_on(complex.n_vertices(), complex.n_faces())
                              ? ContractionLoop(complex, restraints, *cost, options, target, frame, host).run()
                              : cancelled_at_once(complex);
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  const std::uint64_t n_contracted = result.threshold_pairs.contracted;
  result.threshold_pairs = counts_of(pairs, options);
  result.threshold_pairs.contracted = n_contracted;
  result.warnings = warnings_about(mesh, result.threshold_pairs);
  Decimation out = make_output(mesh, complex, frame, options.normals, options.keep_quadrics ? cost.get() : nullptr);
  out.feature_edges = output_features(restraints.feature_edges(complex), complex, out.vertex_map);
  out.result = std::move(result);
  compare_surfaces(mesh, before, complex, options, out);
  return out;
}

}  // namespace

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
  return run(mesh, target, options, nullptr);
}

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                    DecimationHost& host) {
  return run(mesh, target, options, &host);
}

}  // namespace whittle
