#include "decimate/run.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "decimate/checks.hh"
#include "decimate/input_features.hh"
#include "decimate/output.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {
namespace {

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

/// What a pass does that is cancelled before it starts.
DecimateResult cancelled_at_once(const TriangleComplex& complex) {
  DecimateResult result;
  result.n_vertices = complex.n_vertices();
  result.n_faces = complex.n_faces();
  result.stop = StopReason::cancelled;
  return result;
}

/// Adds what was done in blocks to the result of the pass after them.
void add_levels(const DecimateResult& levels, DecimateResult& result) {
  result.n_contractions += levels.n_contractions;
  result.max_cost = std::max(result.max_cost, levels.max_cost);
  result.n_degenerate_faces += levels.n_degenerate_faces;
  result.n_coincident_faces += levels.n_coincident_faces;
  result.rejections += levels.rejections;
}

/// Decimates in blocks where that is worth while, and then as a whole.
class Run {
 public:
  Run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options, DecimationHost* host)
      : mesh_(mesh),
        target_(target),
        options_(options),
        host_(host),
        frame_(host && host->state() ? host->state()->frame : Frame::of_points(mesh.positions)) {}

  Decimation decimate(const BlockPlan& plan);

 private:
  Decimation decimate_rest();
  DecimateOptions options_of_rest() const;
  bool is_beyond_target(const DecimateResult& result) const;
  PassInput last_input();
  DecimateResult run_last(Pass& pass, Preparation& preparation);
  NonmanifoldCounts count_before(Pass& pass) const;

  const IndexedMesh& mesh_;
  DecimateTarget target_;
  const DecimateOptions& options_;
  DecimationHost* host_;
  Frame frame_;
  std::optional<Remainder> remainder_;  ///< of blocks
  double progress_ = 0;                 ///< that has been told
  double last_max_cost_ = 0;            ///< of the last pass
  // What the last pass gets.
  ThresholdPairs pairs_;
  std::vector<VertexPair> features_;
  std::vector<std::uint8_t> locked_;
};

PassInput Run::last_input() {
  PassInput input;
  input.threshold_pairs = pairs_.pairs;
  input.features = features_;
  input.feature_tolerance = options_.feature_tolerance * bounds_of(mesh_.positions).diagonal() * frame_.scale;
  input.host = host_;
  if (!remainder_) {
    input.surface = {mesh_.positions, frame_, mesh_.faces};
    input.locked = options_.locked;
    return input;
  }
  input.surface = {remainder_->positions, Frame{}, remainder_->faces};
  input.memory = &remainder_->memory;
  input.context.refusals = remainder_->refusals;
  locked_ = remainder_->of_vertices(options_.locked);
  input.locked = locked_;
  return input;
}

DecimateResult Run::run_last(Pass& pass, Preparation& preparation) {
  TriangleComplex& complex = pass.complex();
  const bool is_cancelled = remainder_ && remainder_->is_cancelled;
  DecimateResult result;
  if (!is_cancelled && preparation.goes_on(complex.n_vertices(), complex.n_faces())) {
    pass.start(target_, frame_);
    result = pass.run();
  } else {
    result = cancelled_at_once(complex);
  }
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  last_max_cost_ = result.max_cost;
  if (remainder_) add_levels(remainder_->result, result);
  const std::uint64_t n_contracted = result.threshold_pairs.contracted;
  result.threshold_pairs = counts_of(pairs_, options_);
  result.threshold_pairs.contracted = n_contracted;
  result.warnings = warnings_about(mesh_, result.threshold_pairs);
  return result;
}

/// Of the input. \param pass before its first contraction
NonmanifoldCounts Run::count_before(Pass& pass) const {
  if (!remainder_) return pass.complex().count_nonmanifold();
  if (!remainder_->is_cancelled) return remainder_->nonmanifold;
  TriangleComplex input(mesh_.positions, mesh_.faces, frame_, options_.threads);  // blocks not begun are not counted
  input.connect({}, options_.threads);
  return input.count_nonmanifold();
}

/// The callbacks are told of a part of the progress, and of the input's vertices.
DecimateOptions Run::options_of_rest() const {
  DecimateOptions options = options_;
  if (progress_ > 0 && options.progress) {
    options.progress = [done = progress_, callback = options.progress](Progress progress) {
      progress.fraction = done + (1 - done) * progress.fraction;
      return callback(progress);
    };
  }
  if (remainder_ && options.listener) {
    options.listener = [this, callback = options.listener](Contraction contraction) {
      contraction.survivor = remainder_->origins[contraction.survivor];
      contraction.removed = remainder_->origins[contraction.removed];
      callback(contraction);
    };
  }
  return options;
}

/// What is left after blocks, or all.
Decimation Run::decimate_rest() {
  const DecimateOptions options = options_of_rest();
  Preparation preparation(options);
  pairs_ = threshold_pairs(mesh_, options, preparation);
  features_ = input_features(mesh_, options);
  Pass pass(last_input(), options);
  const NonmanifoldCounts before = count_before(pass);
  DecimateResult result = run_last(pass, preparation);
  Decimation out = make_output(mesh_, remainder_ ? &*remainder_ : nullptr, pass, frame_, options_);
  out.feature_edges = output_features(pass.feature_edges(), pass.complex(), out.vertex_map);
  out.result = std::move(result);
  compare_surfaces(mesh_, before, pass.complex(), options_, out);
  return out;
}

/// Whether blocks may have made contractions in exact order that come after the last one.
bool Run::is_beyond_target(const DecimateResult& result) const {
  return remainder_ && is_exact_in_blocks(options_) && result.stop == StopReason::target &&
         !(remainder_->result.max_cost < last_max_cost_);
}

Decimation Run::decimate(const BlockPlan& plan) {
  std::string_view why_in_one_pass = why_not_in_blocks(mesh_, target_, options_, host_, plan);
  if (why_in_one_pass.empty()) {
    remainder_ = decimate_in_blocks(mesh_, frame_, target_, options_, plan);
    progress_ = remainder_->progress;
  }
  if (remainder_ && remainder_->is_futile) {
    why_in_one_pass = "pairs wait for each other all over the mesh";
    remainder_.reset();
  }
  Decimation out = decimate_rest();
  if (is_beyond_target(out.result)) {
    why_in_one_pass = "blocks went beyond the target";
    remainder_.reset();
    progress_ = 1;
    out = decimate_rest();
  }
  out.result.why_in_one_pass = why_in_one_pass;
  return out;
}

}  // namespace

Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan) {
  check(target, options, mesh.positions.size());
  check(mesh);
  return Run(mesh, target, options, host).decimate(plan);
}

}  // namespace whittle
