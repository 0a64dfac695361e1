#include "decimate/staged_run.hh"

#include <algorithm>
#include <memory>
#include <utility>

#include "cost/fold_edges.hh"
#include "cost/seam_planes.hh"
#include "decimate/input_lines.hh"
#include "loop/contraction_log.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {

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

namespace {

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

/// What a stage does that is cancelled before it starts.
DecimateResult cancelled_at_once(const TriangleComplex& complex) {
  DecimateResult result;
  result.n_vertices = complex.n_vertices();
  result.n_faces = complex.n_faces();
  result.stop = StopReason::cancelled;
  return result;
}

}  // namespace

/// How much of the way to the target is behind once `stop` is reached, of that which is left now. [0, 1]
double StagedRun::way_to(const DecimateTarget& stop) const {
  const auto share = [](std::optional<std::uint64_t> from, std::optional<std::uint64_t> to, std::size_t now) {
    if (!from || *to >= now) return 0.0;
    return static_cast<double>(now - std::min<std::uint64_t>(now, *from)) / static_cast<double>(now - *to);
  };
  return std::max(share(stop.n_faces(), target_.n_faces(), n_faces_left()),
                  share(stop.n_vertices(), target_.n_vertices(), n_vertices_left()));
}

void StagedRun::tell_part_of_progress(double begin, double end, DecimateOptions& options) {
  if (!options.progress || (begin <= 0 && end >= 1)) return;
  options.progress = [begin, end, callback = options.progress](Progress progress) {
    progress.fraction = begin + (end - begin) * progress.fraction;
    return callback(progress);
  };
}

/// The callbacks are told of a part of the progress, and of the input's vertices. \param end of that part
DecimateOptions StagedRun::options_of_stage(double end) {
  DecimateOptions options = options_;
  options.topology = topology();
  tell_part_of_progress(report().progress, end, options);
  if (is_listener_told_at_end()) options.listener = {};
  if (!surface().is_input() && options.listener) {
    options.listener = [this, callback = options.listener](Contraction contraction) {
      contraction.survivor = surface().origins[contraction.survivor];
      contraction.removed = surface().origins[contraction.removed];
      callback(contraction);
    };
  }
  return options;
}

/// Finds threshold pairs, lines and planes of seams.
ThresholdPairCounts StagedRun::prepare_input(const DecimateOptions& options, Preparation& preparation) {
  WorkingSurface& surface = state_.surface;
  ThresholdPairs pairs = threshold_pairs(mesh_, options, preparation);
  const ThresholdPairCounts counts = counts_of(pairs, options_);
  surface.threshold_pairs = std::move(pairs.pairs);
  const bool has_hosted_cost = host_ != nullptr && host_->cost() != nullptr;  // which knows of no seams
  InputLines lines = input_lines(mesh_, options_, options_.holds_seams() || has_hosted_cost);
  surface.lines = std::move(lines.held);
  const std::vector<VertexPair> folds = held_folds(mesh_, frame_, options_);
  surface.cost_state.seams = seam_planes(mesh_, frame_, lines.seams, folds, options_);
  return counts;
}

/// For the first stage. Later ones take over what the one before left.
void StagedRun::look_at_attributes_of_input() {
  WorkingSurface& surface = state_.surface;
  if (!surface.is_input() || surface.input_attributes || host_ || !looks_at_attributes(options_, mesh_)) return;
  ScaledAttributes attributes = scaled_attributes(mesh_, frame_, options_.attribute_weights, options_.threads);
  if (attributes.n_components == 0) return;
  surface.input_attributes = std::make_shared<const InputAttributes>(mesh_, frame_, std::move(attributes));
}

/// Of the input. \param contractor before its first contraction
void StagedRun::count_before(Contractor& contractor) {
  if (nonmanifold_before_) return;
  // Blocks not begun are not counted.
  nonmanifold_before_ = surface().is_input() ? contractor.complex().count_nonmanifold() : count_nonmanifold(input());
}

NonmanifoldCounts StagedRun::count_nonmanifold(const WorkingSurface& surface) const {
  TriangleComplex complex(surface.positions, surface.faces, surface.frame, options_.threads);
  complex.connect({}, options_.threads);
  return complex.count_nonmanifold();
}

DecimateResult StagedRun::run(Contractor& contractor, const DecimateTarget& stop, Preparation& preparation) const {
  TriangleComplex& complex = contractor.complex();
  DecimateResult result;
  if (!is_cancelled() && preparation.goes_on(complex.n_vertices(), complex.n_faces())) {
    contractor.start(stop);
    result = contractor.run();
  } else {
    result = cancelled_at_once(complex);
  }
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  return result;
}

/// \param log what the stage did, by the vertices that it began with
void StagedRun::keep_steps_of_stage(std::span<Contraction> log, StageReport& report) const {
  tell_by_input(mesh_.positions, frame_, surface().origins, log);
  report.steps.contractions.assign(log.begin(), log.end());
  end_pass(report.steps);
}

/// By the input's vertices. \param contractor that has ended; what it began with is still there
std::vector<RefusedPair> StagedRun::refused_pairs(Contractor& contractor) const {
  std::vector<RefusedPair> refused;
  for (const auto& [pair, reason] : contractor.refusals()) {
    if (reason) refused.push_back({{surface().origin_of(pair.a), surface().origin_of(pair.b)}, *reason});
  }
  return refused;
}

/// Whether blocks have left nothing to do.
bool StagedRun::is_at(const DecimateTarget& stop) const {
  const bool is_reached = stop.is_reached_at(n_faces_left(), n_vertices_left());
  return is_reached && !surface().is_input() && !is_cancelled() && !options_.keep_quadrics;
}

/// A stage in which nothing is to be done.
DecimateResult StagedRun::end_at_once(StageReport report) {
  if (keeps_steps()) end_pass(report.steps);
  report.result.stop = StopReason::target;
  report.result.n_vertices = n_vertices_left();
  report.result.n_faces = n_faces_left();
  DecimateResult result = report.result;
  state_.report += std::move(report);
  return result;
}

DecimateResult StagedRun::contract(const DecimateTarget& stop, bool is_last, const StageLimits& limits) {
  WorkingSurface& surface = state_.surface;
  StageReport report;
  report.progress = state_.report.progress + (1 - state_.report.progress) * way_to(stop);
  if (is_at(stop)) return end_at_once(std::move(report));
  const DecimateOptions options = options_of_stage(report.progress);
  Preparation preparation(options);
  ThresholdPairCounts pairs;
  if (surface.is_input()) pairs = prepare_input(options, preparation);
  look_at_attributes_of_input();
  if (const auto attributes = std::exchange(surface.input_attributes, {})) {
    surface.cost_state.attributes = attributes->all(options.threads);
  }
  const std::vector<std::uint8_t> locked = surface.of_vertices(options_.locked);
  const std::vector<Index> kept_areas = surface.of_faces(areas().of(stop));
  LargeArray<Contraction> made(keeps_steps() ? n_vertices_left() : 0);
  ContractionLog log{made.data()};
  StageContext context{options, frame_, host_, limits};
  context.feature_tolerance = options_.feature_tolerance * diagonal_of(mesh_.positions) * frame_.scale;
  context.locked = locked;
  if (!kept_areas.empty()) context.areas = {surface.faces, kept_areas, true};
  if (keeps_steps()) context.log = &log;
  Contractor contractor(surface, context);
  count_before(contractor);
  report.result = run(contractor, stop, preparation);
  DecimateResult result = report.result;
  report.result.threshold_pairs += pairs;
  is_last = is_last || (result.stop != StopReason::target && !limits.displacement);
  if (keeps_steps()) keep_steps_of_stage({made.data(), log.end}, report);
  if (result.stop == StopReason::exhausted) report.refused_pairs = refused_pairs(contractor);
  std::optional<NonmanifoldCounts> nonmanifold;
  if (is_last) nonmanifold = contractor.complex().count_nonmanifold();
  contractor.write_back(surface, !is_last);
  surface.nonmanifold = nonmanifold;
  state_.report += std::move(report);
  return result;
}

}  // namespace whittle
