#include "decimate/run.hh"

#include <algorithm>
#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
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
void compare_surfaces(const IndexedMesh& input, const NonmanifoldCounts& before, const NonmanifoldCounts& after,
                      const DecimateOptions& options, Decimation& out) {
  out.result.after = surface_counts(find_parts(out.mesh.positions.size(), out.mesh.faces).count, after);
  out.result.before = surface_counts(out.result.after.components, before);
  const bool is_manifold = before.edges == 0 && before.vertices == 0;
  const bool has_pairs = options.pairs.threshold > 0;
  if (!has_pairs && options.topology == Topology::keep && is_manifold) return;  // parts stay parts
  const Parts parts = find_parts(input.positions.size(), input.faces);
  out.result.before.components = parts.count;
  out.result.n_vanished_components = count_vanished(parts, out.vertex_map);
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

/// Adds what was done before to the result of a pass.
void add_earlier(const DecimateResult& earlier, DecimateResult& result) {
  result.n_contractions += earlier.n_contractions;
  result.max_cost = std::max(result.max_cost, earlier.max_cost);
  result.n_degenerate_faces += earlier.n_degenerate_faces;
  result.n_coincident_faces += earlier.n_coincident_faces;
  result.rejections += earlier.rejections;
  result.threshold_pairs.contracted += earlier.threshold_pairs.contracted;
}

IndexedMesh surface_of(const Remainder& left) {
  IndexedMesh surface;
  surface.positions = left.positions;
  surface.faces = left.faces;
  return surface;
}

/// What has been done, in blocks and in passes.
struct Done {
  std::optional<Remainder> left;  ///< before the first contraction: none
  DecimateResult result;
  double progress = 0;                           ///< that has been told
  std::optional<double> max_cost_in_blocks;      ///< none if there are none
  double max_cost_of_pass = 0;                   ///< of the last one
  bool is_cancelled = false;                     ///< in blocks
  std::optional<NonmanifoldCounts> nonmanifold;  ///< of what is left; none if it was to go on
  std::vector<Contraction> contractions;         ///< to tell the listener of, where they may be taken back
};

/// What a pass begins with, and what of that is the pass's own.
struct PassStart {
  PassInput input;
  ThresholdPairs found_pairs;
  FeatureLines found_lines;
  std::vector<std::uint8_t> locked;
};

/// Decimates in blocks where that is worth while, and then as a whole: in one pass, or with pauses between several.
class Run {
 public:
  Run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options, DecimationHost* host)
      : mesh_(mesh),
        target_(target),
        options_(options),
        host_(host),
        frame_(host && host->state() ? host->state()->frame : Frame::of_points(mesh.positions)) {}

  Decimation decimate(const BlockPlan& plan);
  /// After `decimate`: null if the error is not limited, or if that was cancelled early.
  std::unique_ptr<ErrorBounds> take_error_bounds() { return std::move(error_bounds_); }

 private:
  std::string_view contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan);
  DecimateTarget least_left_in_blocks() const;
  std::vector<DecimateTarget> stops() const;
  std::size_t n_faces_left() const { return done_.left ? done_.left->faces.size() : mesh_.faces.size(); }
  std::size_t n_vertices_left() const { return done_.left ? done_.left->positions.size() : mesh_.positions.size(); }
  double way_to(const DecimateTarget& stop) const;
  void contract_to(const DecimateTarget& stop, bool is_last);
  void contract_to_stops(const BlockPlan& plan);
  void contract_within_error(const BlockPlan& plan);
  void contract_what_moves_little(double displacement);
  std::vector<double> limits_of_vertices() const;
  void contract_to_shares_of_limit(const std::vector<double>& limits, const std::vector<double>& shares);
  void lower_shares_at(const std::vector<Index>& vertices, std::vector<double>& shares) const;
  void make_coarse_bound(const Done& start);
  bool contract_guarded();
  ErrorBound::Violations find_violations_before_guarding();
  ErrorBound& guarding_bound() { return coarse_bound_ ? *coarse_bound_ : error_bounds_->surface(); }
  std::vector<Index> map_from_start() const;
  void end_within_error();
  void begin_with_input(PassStart& start, const DecimateOptions& options, Preparation& preparation);
  void begin_with_remainder(PassStart& start) const;
  DecimateResult run(Pass& pass, const DecimateTarget& stop, Preparation& preparation) const;
  void count_before(Pass& pass);
  NonmanifoldCounts count_nonmanifold(const Surface& surface) const;
  void keep_contractions(DecimateOptions& options);
  DecimateOptions options_of_pass(double end);
  bool is_beyond_target() const;
  bool adjust();
  void forget_all();
  Decimation output();

  const IndexedMesh& mesh_;
  DecimateTarget target_;
  const DecimateOptions& options_;
  DecimationHost* host_;
  Frame frame_;

  // If the error is limited:
  std::unique_ptr<ErrorBounds> error_bounds_;
  std::unique_ptr<ErrorBound> coarse_bound_;  ///< of the surface, to a coarse copy of the input; or null
  std::vector<Index> start_origins_;          ///< vertices that the second step begins with → those of the input
  std::optional<double> displacement_limit_;  ///< of the pass, if it has one; in the frame
  std::vector<double> displacement_limits_;   ///< of the vertices that the pass begins with, where they differ
  bool is_guarded_ = false;                   ///< whether the pass keeps the bounds

  Done done_;
  std::optional<NonmanifoldCounts> nonmanifold_before_;  ///< of the input
  ThresholdPairCounts pairs_;                            ///< of the input
};

/// \return why it was done otherwise; empty if blocks have contracted
std::string_view Run::contract_in_blocks(const DecimateTarget& target, const BlockPlan& plan) {
  const std::string_view why_not = why_not_in_blocks(mesh_, target, options_, host_, plan);
  if (!why_not.empty()) return why_not;
  DecimateOptions options = options_;
  keep_contractions(options);
  LevelRemainder levels = decimate_in_blocks(mesh_, frame_, target, options, plan, displacement_limit_);
  done_.progress = levels.progress;
  if (levels.is_futile) return "pairs wait for each other all over the mesh";
  done_.is_cancelled = levels.is_cancelled;
  if (!done_.is_cancelled) nonmanifold_before_ = levels.nonmanifold;
  done_.max_cost_in_blocks = levels.result.max_cost;
  done_.result = std::move(levels.result);
  done_.left = std::move(levels);
  return {};
}

/// What blocks that move the surface little leave at least.
DecimateTarget Run::least_left_in_blocks() const {
  constexpr std::uint64_t least_share = 20;  // a 20th
  DecimateTarget left =
      DecimateTarget::faces(std::max(mesh_.faces.size() / least_share, target_.n_faces().value_or(1)));
  if (target_.n_vertices()) left = left.or_vertices(*target_.n_vertices());
  if (target_.cost_limit()) left = left.or_max_cost(*target_.cost_limit());
  return left;
}

/// Where contractions may be taken back, the listener is told of them in the end.
void Run::keep_contractions(DecimateOptions& options) {
  if (!options.listener || !target_.error_limit()) return;
  options.listener = [this](const Contraction& contraction) { done_.contractions.push_back(contraction); };
}

/// Where to pause, and at last the target.
std::vector<DecimateTarget> Run::stops() const {
  std::vector<DecimateTarget> stops;
  const bool has_count = target_.n_faces() || target_.n_vertices();
  for (const double factor : options_.pauses.at) {
    const DecimateTarget stop = target_.with_counts_times(factor);
    if (has_count && !stop.is_reached_at(n_faces_left(), n_vertices_left())) stops.push_back(stop);
  }
  stops.push_back(target_);
  return stops;
}

/// How much of the way to the target is behind once `stop` is reached, of that which is left now. [0, 1]
double Run::way_to(const DecimateTarget& stop) const {
  const auto share = [](std::optional<std::uint64_t> from, std::optional<std::uint64_t> to, std::size_t now) {
    if (!from || *to >= now) return 0.0;
    return static_cast<double>(now - std::min<std::uint64_t>(now, *from)) / static_cast<double>(now - *to);
  };
  return std::max(share(stop.n_faces(), target_.n_faces(), n_faces_left()),
                  share(stop.n_vertices(), target_.n_vertices(), n_vertices_left()));
}

void Run::begin_with_input(PassStart& start, const DecimateOptions& options, Preparation& preparation) {
  start.found_pairs = threshold_pairs(mesh_, options, preparation);
  pairs_ = counts_of(start.found_pairs, options_);
  start.found_lines.edges = input_features(mesh_, options_);
  start.input.surface = {mesh_.positions, frame_, mesh_.faces};
  start.input.threshold_pairs = start.found_pairs.pairs;
  start.input.lines = &start.found_lines;
  start.input.locked = options_.locked;
}

/// \pre there is one
void Run::begin_with_remainder(PassStart& start) const {
  const Remainder& left = *done_.left;
  start.locked = left.of_vertices(options_.locked);
  start.input.surface = {left.positions, Frame{}, left.faces};
  start.input.threshold_pairs = left.threshold_pairs;
  start.input.lines = &left.lines;
  start.input.memory = &left.memory;
  start.input.context.refusals = left.refusals;
  start.input.locked = start.locked;
}

DecimateResult Run::run(Pass& pass, const DecimateTarget& stop, Preparation& preparation) const {
  TriangleComplex& complex = pass.complex();
  DecimateResult result;
  if (!done_.is_cancelled && preparation.goes_on(complex.n_vertices(), complex.n_faces())) {
    pass.start(stop, frame_);
    result = pass.run();
  } else {
    result = cancelled_at_once(complex);
  }
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  return result;
}

/// Of the input. \param pass before its first contraction
void Run::count_before(Pass& pass) {
  if (nonmanifold_before_) return;
  if (!done_.left) {
    nonmanifold_before_ = pass.complex().count_nonmanifold();
    return;
  }
  nonmanifold_before_ = count_nonmanifold({mesh_.positions, frame_, mesh_.faces});  // blocks not begun are not counted
}

NonmanifoldCounts Run::count_nonmanifold(const Surface& surface) const {
  TriangleComplex complex(surface.positions, surface.faces, surface.frame, options_.threads);
  complex.connect({}, options_.threads);
  return complex.count_nonmanifold();
}

/// The callbacks are told of a part of the progress, and of the input's vertices. \param end of that part
DecimateOptions Run::options_of_pass(double end) {
  DecimateOptions options = options_;
  if ((done_.progress > 0 || end < 1) && options.progress) {
    options.progress = [begin = done_.progress, end, callback = options.progress](Progress progress) {
      progress.fraction = begin + (end - begin) * progress.fraction;
      return callback(progress);
    };
  }
  keep_contractions(options);
  if (done_.left && options.listener) {
    options.listener = [this, callback = options.listener](Contraction contraction) {
      contraction.survivor = done_.left->origins[contraction.survivor];
      contraction.removed = done_.left->origins[contraction.removed];
      callback(contraction);
    };
  }
  return options;
}

/// Contracts what is left, or the input, in one pass. \param is_last whether no other pass follows
void Run::contract_to(const DecimateTarget& stop, bool is_last) {
  const double end = done_.progress + (1 - done_.progress) * way_to(stop);
  const DecimateOptions options = options_of_pass(end);
  Preparation preparation(options);
  PassStart start;
  if (done_.left) {
    begin_with_remainder(start);
  } else {
    begin_with_input(start, options, preparation);
  }
  start.input.feature_tolerance = options_.feature_tolerance * bounds_of(mesh_.positions).diagonal() * frame_.scale;
  start.input.host = host_;
  start.input.context.displacement_limit = displacement_limit_;
  start.input.context.displacement_limits = displacement_limits_;
  if (is_guarded_) {
    start.input.context.error_bound = &guarding_bound();
    start.input.context.border_bound = error_bounds_->borders();
  }
  Pass pass(start.input, options);
  count_before(pass);
  DecimateResult result = run(pass, stop, preparation);
  is_last = is_last || (result.stop != StopReason::target && !displacement_limit_);
  done_.progress = end;
  done_.max_cost_of_pass = result.max_cost;
  add_earlier(done_.result, result);
  done_.result = std::move(result);
  if (is_last) done_.nonmanifold = pass.complex().count_nonmanifold();
  done_.left = remainder_of(pass, start.input.surface.faces, done_.left ? &*done_.left : nullptr,
                            {.what_to_go_on_from = !is_last, .quadrics = options_.keep_quadrics});
}

/// Whether blocks may have made contractions in exact order that come after the last one.
bool Run::is_beyond_target() const {
  return done_.max_cost_in_blocks && is_exact_in_blocks(options_) && done_.result.stop == StopReason::target &&
         !(*done_.max_cost_in_blocks < done_.max_cost_of_pass);
}

/// Lets the pause change what is left. \return whether to go on
bool Run::adjust() {
  Remainder& left = *done_.left;
  Decimation paused = geometry_of(mesh_, left, frame_);
  paused.result = done_.result;
  const std::vector<Vec3> before = paused.mesh.positions;
  const std::size_t n_faces = paused.mesh.faces.size();
  const bool goes_on = options_.pauses.adjust(paused);
  if (paused.mesh.positions.size() != before.size() || paused.mesh.faces.size() != n_faces) {
    throw std::invalid_argument("decimate: a pause changed the number of vertices or faces");
  }
  check(paused.mesh);
  left.faces = std::move(paused.mesh.faces);
  auto remembered = left.memory.quadrics.begin();
  for (Index v = 0; v < before.size(); ++v) {
    Quadric* const quadric =
        remembered != left.memory.quadrics.end() && remembered->vertex == v ? &(remembered++)->quadric : nullptr;
    if (paused.mesh.positions[v] == before[v]) continue;
    const Vec3 position = frame_.to_frame(paused.mesh.positions[v]);
    if (quadric) *quadric = quadric->about(position - left.positions[v]);
    left.positions[v] = position;
  }
  return goes_on;
}

void Run::forget_all() {
  done_ = {};
  done_.progress = 1;
}

Decimation Run::output() {
  if (!done_.nonmanifold) {
    done_.nonmanifold = count_nonmanifold({done_.left->positions, Frame{}, done_.left->faces});
  }
  Decimation out = geometry_of(mesh_, std::move(*done_.left), frame_);
  add_attributes(mesh_, frame_, options_, out);
  out.result = std::move(done_.result);
  pairs_.contracted = out.result.threshold_pairs.contracted;
  out.result.threshold_pairs = pairs_;
  out.result.warnings = warnings_about(mesh_, pairs_);
  compare_surfaces(mesh_, *nonmanifold_before_, *done_.nonmanifold, options_, out);
  return out;
}

/// Contracts as far as the error may be, in three steps: what moves the surface by next to nothing, which leaves a
/// coarse copy of a large input; what hardly moves it; and what keeps near to the coarse copy, or to the input. What is
/// left is proven to be near to the input. Where it isn't, the next try is less bold.
void Run::contract_within_error(const BlockPlan& plan) {
  constexpr std::size_t fewest_faces_of_coarse_copy = 200'000;
  constexpr int most_tries = 4;
  const double limit = *target_.error_limit() * frame_.scale;
  const auto make_bounds = [&] {
    const double border_limit = *target_.border_error_limit() * frame_.scale;
    return std::make_unique<ErrorBounds>(mesh_, frame_, limit, border_limit, options_.threads, options_.tolerances);
  };
  const bool has_threads = n_threads(options_.threads) > 1;
  auto bounds =
      std::async(has_threads ? std::launch::async | std::launch::deferred : std::launch::deferred, make_bounds);
  const bool has_tolerances = !options_.tolerances.empty();
  if (has_tolerances) error_bounds_ = bounds.get();
  if (mesh_.faces.size() >= fewest_faces_of_coarse_copy && !has_tolerances) {
    displacement_limit_ = 0.02 * limit;
    contract_in_blocks(least_left_in_blocks(), plan);
    contract_what_moves_little(0.02 * limit);
  }
  Done start = done_;
  if (start.left) start_origins_ = start.left->origins;
  std::vector<double> limits = has_tolerances ? limits_of_vertices() : std::vector<double>(n_vertices_left(), limit);
  std::vector<double> shares(limits.size(), 0.3);
  for (int i = 0; i < most_tries; ++i) {
    done_ = start;
    contract_to_shares_of_limit(limits, shares);
    if (!error_bounds_) {
      error_bounds_ = bounds.get();
      make_coarse_bound(start);
    }
    const ErrorBound::Violations violations = find_violations_before_guarding();
    if (violations.empty() && contract_guarded()) return end_within_error();
    if (i + 2 < most_tries) {
      lower_shares_at(violations.vertices, shares);
    } else {
      start = {};
      start_origins_.clear();
      coarse_bound_.reset();
      limits.assign(mesh_.positions.size(), 0);
      shares.assign(mesh_.positions.size(), 0);
    }
  }
  forget_all();
  contract_to(DecimateTarget::faces(mesh_.faces.size()), true);  // nothing
  done_.result.stop = StopReason::error;
  end_within_error();
}

/// Of each vertex of the input, in the frame.
std::vector<double> Run::limits_of_vertices() const {
  std::vector<double> limits;
  limits.reserve(mesh_.positions.size());
  for (Index v = 0; v < mesh_.positions.size(); ++v) limits.push_back(error_bounds_->surface().limit_at(v));
  return limits;
}

/// \param shares of the limit of each vertex: what a contraction at it may move the surface by
void Run::contract_to_shares_of_limit(const std::vector<double>& limits, const std::vector<double>& shares) {
  displacement_limits_.clear();
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t v = 0; v < limits.size(); ++v) {
    const double displacement = limits[v] * shares[v];
    least = std::min(least, displacement);
    most = std::max(most, displacement);
    displacement_limits_.push_back(displacement);
  }
  if (least == most) displacement_limits_.clear();
  contract_what_moves_little(most);
}

/// Of vertices that the second step began with, where they became one of those that are left, or of their neighbours:
/// from three tenths to one, and then to nothing. If none is named, of all.
void Run::lower_shares_at(const std::vector<Index>& vertices, std::vector<double>& shares) const {
  constexpr double bold = 0.2;
  constexpr double less_bold = 0.1;
  const std::vector<Index> map = map_from_start();
  std::vector<std::uint8_t> is_named(done_.left->positions.size(), vertices.empty() ? 1 : 0);
  for (const Index v : vertices) is_named[v] = 1;
  std::vector<std::uint8_t> is_near = is_named;
  for (const auto& [a, b, c] : done_.left->faces) {
    if ((is_named[a] | is_named[b] | is_named[c]) != 0) is_near[a] = is_near[b] = is_near[c] = 1;
  }
  for (std::size_t v = 0; v < shares.size(); ++v) {
    if (map[v] != invalid_index && is_near[map[v]] != 0) shares[v] = shares[v] > bold ? less_bold : 0;
  }
}

/// Vertices that the second step began with → those that are left.
std::vector<Index> Run::map_from_start() const {
  if (start_origins_.empty()) return done_.left->vertex_map;
  std::vector<Index> map;
  map.reserve(start_origins_.size());
  for (const Index v : start_origins_) map.push_back(done_.left->vertex_map[v]);
  return map;
}

/// \param displacement of the surface by one contraction, at most, about; in the frame
void Run::contract_what_moves_little(double displacement) {
  if (done_.result.stop == StopReason::cancelled) return;
  displacement_limit_ = displacement;
  contract_to(target_, false);
  displacement_limit_.reset();
}

/// Makes one of what the second step begins with, if that is much smaller than the input.
void Run::make_coarse_bound(const Done& start) {
  constexpr double share_of_limit = 0.06;  // three times that of a contraction, as several add up
  if (!start.left || 2 * start.left->faces.size() > mesh_.faces.size()) return;
  if (done_.result.stop == StopReason::cancelled) return;
  const double limit = (1 - share_of_limit) * error_bounds_->surface().limit();
  coarse_bound_ = std::make_unique<ErrorBound>(surface_of(*start.left), Frame{}, limit, options_.threads);
}

/// Contracts what keeps the bounds. Points of the input that are found to be too far in the end are then looked at,
/// too. A coarse bound is made smaller if the surface is too far from the input.
/// \pre find_violations_before_guarding().empty()
/// \return whether what is left is proven to be near to the input, or the run is cancelled
bool Run::contract_guarded() {
  constexpr int most_tries = 3;
  const Done before = done_;
  for (int i = 0; i < most_tries; ++i) {
    if (done_.result.stop == StopReason::cancelled) return true;
    if (i > 0 && !find_violations_before_guarding().empty()) return false;
    is_guarded_ = true;
    contract_to(target_, true);
    is_guarded_ = false;
    if (done_.result.stop == StopReason::cancelled) return true;
    const IndexedMesh surface = surface_of(*done_.left);
    // The guard has proven each face, unless it compared with a coarse copy.
    const std::vector<std::uint8_t> is_proven(surface.faces.size(), coarse_bound_ ? 0 : 1);
    const CheckedSurface checked{surface, Frame{}, done_.left->vertex_map, is_proven};
    ErrorBound& exact = error_bounds_->surface();
    const ErrorBound::Violations violations = exact.check(checked, exact.limit());
    const ErrorBound::Violations of_borders = error_bounds_->check_borders(checked);
    if (violations.empty() && of_borders.empty()) return true;
    if (of_borders.is_surface_far || (violations.is_surface_far && !coarse_bound_)) return false;
    if (violations.is_surface_far) coarse_bound_->tighten();
    guarding_bound().add_points(violations.points);
    if (error_bounds_->borders() != nullptr) error_bounds_->borders()->add_points(of_borders.points);
    done_ = before;
  }
  return false;
}

/// The guards look at the supports that are found with them.
ErrorBound::Violations Run::find_violations_before_guarding() {
  if (done_.result.stop == StopReason::cancelled) return {};
  const IndexedMesh surface = surface_of(*done_.left);
  const CheckedSurface checked{surface, Frame{}, done_.left->vertex_map};
  if (!coarse_bound_) return error_bounds_->check(checked);
  const std::vector<Index> map = map_from_start();
  ErrorBound::Violations violations = coarse_bound_->check({surface, Frame{}, map}, coarse_bound_->limit());
  violations.add(error_bounds_->check_borders(checked));
  return violations;
}

void Run::end_within_error() {
  DecimateResult& result = done_.result;
  for (const Contraction& contraction : done_.contractions) options_.listener(contraction);
  if (result.stop == StopReason::cancelled) return;
  result.proven_error = target_.error_limit();
  if (result.stop == StopReason::exhausted && result.refused_at_end.error > 0) result.stop = StopReason::error;
}

/// Contracts in blocks where that is worth while, and then to each stop in turn.
void Run::contract_to_stops(const BlockPlan& plan) {
  std::string_view why_in_one_pass = contract_in_blocks(target_, plan);
  const std::vector<DecimateTarget> stops = this->stops();
  const auto contract_to_stop = [&](std::size_t i) { contract_to(stops[i], i + 1 == stops.size()); };
  contract_to_stop(0);
  if (is_beyond_target()) {
    why_in_one_pass = "blocks went beyond the target";
    forget_all();
    contract_to_stop(0);
  }
  for (std::size_t i = 1; i < stops.size() && done_.result.stop == StopReason::target; ++i) {
    if (adjust()) {
      contract_to_stop(i);
    } else {
      done_.result.stop = StopReason::cancelled;
    }
  }
  done_.result.why_in_one_pass = why_in_one_pass;
}

Decimation Run::decimate(const BlockPlan& plan) {
  const bool has_faces = std::any_of(mesh_.faces.begin(), mesh_.faces.end(), has_three_corners);
  if (target_.error_limit() && has_faces) {
    contract_within_error(plan);
    done_.result.why_in_one_pass = why_not_in_blocks(mesh_, target_, options_, host_, plan);
  } else {
    contract_to_stops(plan);
  }
  return output();
}

}  // namespace

Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan, std::unique_ptr<ErrorBounds>* error_bounds) {
  check(target, options, mesh.positions.size());
  check(mesh);
  if (host != nullptr && !options.pauses.at.empty()) {
    throw std::invalid_argument("decimate: pauses don't go with a host");
  }
  if (host != nullptr && target.error_limit()) {
    throw std::invalid_argument("decimate: max_error doesn't go with a host");
  }
  Run run(mesh, target, options, host);
  Decimation decimation = run.decimate(plan);
  if (error_bounds != nullptr) *error_bounds = run.take_error_bounds();
  return decimation;
}

}  // namespace whittle
