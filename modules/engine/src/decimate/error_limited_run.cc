#include "decimate/error_limited_run.hh"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "cost/make_cost.hh"
#include "error/marked_vertices.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle {
namespace {

IndexedMesh surface_of(const WorkingSurface& left) {
  IndexedMesh surface;
  surface.positions.assign(left.positions.begin(), left.positions.end());
  surface.faces.assign(left.faces.begin(), left.faces.end());
  return surface;
}

}  // namespace

/// Contracts in two ways, and takes the one that leaves fewer faces.
std::unique_ptr<ErrorBounds> ErrorLimitedRun::contract(const BlockPlan& plan) {
  const bool is_done = contract_in_steps(plan);
  const auto may_go_on = [this] { return !run_.is_cancelled() && run_.report().result.stop != StopReason::target; };
  if (!is_done && may_go_on()) contract_from_plain_level(plan);
  if (may_go_on() && has_plain_level_near()) {
    make_plain_run(true, plan);
    if (!run_.is_cancelled()) contract_from_plain_level(plan);
  }
  return end();
}

/// \param begins_with_input rather than with what is left now
void ErrorLimitedRun::make_plain_run(bool begins_with_input, const BlockPlan& plan) {
  const StagedRun::State before = run_.state();
  if (begins_with_input) run_.begin_anew(before.report.progress);
  plain_run_.emplace(run_, *error_bounds_, plan);
  if (!run_.is_cancelled()) run_.return_to(before);
}

/// Whether the plain run is proven to leave hardly more faces than there are. Then one that begins with the input may
/// leave fewer: what the second step did is in its way.
bool ErrorLimitedRun::has_plain_level_near() {
  constexpr double near = 1.5;
  const double n_vertices = near * static_cast<double>(run_.n_vertices_left());
  return plain_run_ && plain_run_->is_proven_with_vertices(static_cast<std::size_t>(n_vertices));
}

/// Contracts as far as the error may be, in three steps: what moves the surface by next to nothing, which leaves a
/// coarse copy of a large input; what hardly moves it; and what keeps near to the coarse copy, or to the input. What is
/// left is proven to be near to the input. Where it isn't, the next try is less bold. If none succeeds, what the second
/// step left stays.
/// \return true if a plain level was taken after the second step, as it has far fewer faces
bool ErrorLimitedRun::contract_in_steps(const BlockPlan& plan) {
  constexpr double bold_share = 0.3;
  constexpr int most_bold_tries = 3;
  std::future<std::unique_ptr<ErrorBounds>> bounds = begin_bounds();
  if (has_tolerances()) error_bounds_ = bounds.get();
  contract_to_coarse_copy(plan);
  const StagedRun::State start = run_.state();
  start_origins_ = start.surface.origins;
  std::vector<double> shares(run_.n_vertices_left(), bold_share);
  std::optional<StagedRun::State> hardly_moved;  // what the second step left, the first that may be proven
  for (int i = 0; i < most_bold_tries; ++i) {
    run_.return_to(start);
    contract_to_shares_of_limit(shares, plan);
    if (!error_bounds_) {
      error_bounds_ = bounds.get();
      make_coarse_bound(start.surface);
    }
    if (i == 0 && has_plain_level_far_below(plan) && contract_from_plain_level(plan)) return true;
    const ErrorBound::Violations violations = find_violations_before_guarding();
    if (violations.empty()) {
      if (contract_guarded()) return false;
      if (!hardly_moved) hardly_moved = run_.state();
    }
    lower_shares_at(violations.vertices, shares);
  }
  if (contract_guarded_from_input(plan) || (hardly_moved && end_with(*hardly_moved))) return false;
  contract_nothing();
  return false;
}

/// Whether a plain run is proven to leave far fewer faces than the second step. That step leaves two to six times as
/// many as the third one; of long and thin triangles nearly all, and then the third step takes long.
bool ErrorLimitedRun::has_plain_level_far_below(const BlockPlan& plan) {
  constexpr std::size_t far = 4;
  if (run_.is_cancelled() || is_target_reached()) return false;
  make_plain_run(false, plan);
  return !run_.is_cancelled() && plain_run_->is_proven_with_vertices(run_.n_vertices_left() / far);
}

/// Contracts, from the second step on or from the input, as if there were no limit, as far as the result is proven to
/// be near to the input, and from there what keeps near. \return whether that leaves fewer faces. Else all is as it was
bool ErrorLimitedRun::contract_from_plain_level(const BlockPlan& plan) {
  const StagedRun::State before = run_.state();
  const std::size_t n_faces = run_.n_faces_left();
  std::unique_ptr<ErrorBound> coarse_bound = std::move(coarse_bound_);
  if (!plain_run_) make_plain_run(false, plan);
  const bool has_level = !run_.is_cancelled() && plain_run_->contract_to_coarsest_proven(n_faces, plan);
  if (has_level) {
    if (!find_violations_before_guarding().empty() || !contract_guarded()) contract_no_more();
    if (run_.n_faces_left() < n_faces) return true;
  }
  if (run_.is_cancelled()) return true;
  run_.return_to(before);
  coarse_bound_ = std::move(coarse_bound);
  return false;
}

/// Makes the bounds on another thread, if there is one.
std::future<std::unique_ptr<ErrorBounds>> ErrorLimitedRun::begin_bounds() {
  const bool has_threads = n_threads(run_.options().threads) > 1;
  return std::async(has_threads ? std::launch::async | std::launch::deferred : std::launch::deferred, [this] {
    const double border_limit = *target().border_error_limit() * run_.frame().scale;
    return std::make_unique<ErrorBounds>(run_.mesh(), run_.frame(), limit_, border_limit, run_.options().threads,
                                         run_.options().tolerances);
  });
}

/// Contracts what moves the surface by next to nothing, if the input is large.
void ErrorLimitedRun::contract_to_coarse_copy(const BlockPlan& plan) {
  constexpr std::size_t fewest_faces = 200'000;
  constexpr double share_of_limit = 0.02;
  if (run_.mesh().faces.size() < fewest_faces || has_tolerances()) return;
  const StageLimits limits{.displacement = share_of_limit * limit_};
  const bool is_in_blocks = run_.contract_in_blocks(least_left_in_blocks(), plan, limits).why_in_one_pass.empty();
  if (!is_in_blocks && !run_.is_cancelled()) run_.contract(target(), false, limits);
}

/// What blocks that move the surface little leave at least.
DecimateTarget ErrorLimitedRun::least_left_in_blocks() const {
  constexpr std::uint64_t least_share = 1000;  // a 1000th
  DecimateTarget left =
      DecimateTarget::faces(std::max(run_.mesh().faces.size() / least_share, target().n_faces().value_or(1)));
  if (target().n_vertices()) left = left.or_vertices(*target().n_vertices());
  if (target().cost_limit()) left = left.or_max_cost(*target().cost_limit());
  return left;
}

/// \param shares of the limit of each vertex: what a contraction at it may move the surface by
void ErrorLimitedRun::contract_to_shares_of_limit(const std::vector<double>& shares, const BlockPlan& plan) {
  std::vector<double> displacements;
  displacements.reserve(shares.size());
  for (Index v = 0; v < shares.size(); ++v) {
    const double limit = has_tolerances() ? error_bounds_->surface().limit_at(v) : limit_;
    displacements.push_back(shares[v] * limit);
  }
  const double greatest = *std::max_element(displacements.begin(), displacements.end());
  const bool is_one = std::count(displacements.begin(), displacements.end(), greatest) == std::ssize(displacements);
  if (is_one) displacements.clear();
  contract_what_moves_little({.displacement = greatest, .displacements = displacements}, plan);
}

/// Of vertices that the second step began with, where they became one of those that are left, or of their neighbours:
/// from the first to a tenth, and then to nothing. If none is named, of all.
void ErrorLimitedRun::lower_shares_at(const std::vector<Index>& vertices, std::vector<double>& shares) const {
  constexpr double bold = 0.2;
  constexpr double less_bold = 0.1;
  const std::vector<Index> map = map_from_start();
  const std::vector<std::uint8_t> is_near =
      with_neighbours(marked_vertices(vertices, left().positions.size()), left().faces);
  for (std::size_t v = 0; v < shares.size(); ++v) {
    if (map[v] == invalid_index || (!vertices.empty() && is_near[map[v]] == 0)) continue;
    shares[v] = shares[v] > bold ? less_bold : 0;
  }
}

/// Without a bold step, and without a coarse copy.
bool ErrorLimitedRun::contract_guarded_from_input(const BlockPlan& plan) {
  run_.begin_anew(0);
  start_origins_.clear();
  coarse_bound_.reset();
  contract_what_moves_little({.displacement = 0}, plan);
  return find_violations_before_guarding().empty() && contract_guarded();
}

/// \return whether it is proven to be near to the input
bool ErrorLimitedRun::end_with(const StagedRun::State& state) {
  run_.return_to(state);
  const IndexedMesh surface = surface_of(left());
  if (!error_bounds_->check({surface, Frame{}, left().vertex_map}).empty()) return false;
  contract_no_more();
  return true;
}

void ErrorLimitedRun::contract_nothing() {
  run_.begin_anew(1);
  contract_no_more();
}

void ErrorLimitedRun::contract_no_more() {
  run_.contract(DecimateTarget::faces(run_.n_faces_left()), true);
  run_.report().result.stop = is_target_reached() ? StopReason::target : StopReason::error;
}

/// Vertices that the second step began with → those that are left.
std::vector<Index> ErrorLimitedRun::map_from_start() const {
  if (start_origins_.empty()) return left().vertex_map;
  std::vector<Index> map;
  map.reserve(start_origins_.size());
  for (const Index v : start_origins_) map.push_back(left().vertex_map[v]);
  return map;
}

/// \pre the limits are of displacement
void ErrorLimitedRun::contract_what_moves_little(const StageLimits& limits, const BlockPlan& plan) {
  if (run_.is_cancelled()) return;
  run_.contract_in_blocks(least_left_in_blocks(), plan, limits);
  run_.contract(target(), false, limits);
}

/// Makes one of what the second step begins with, if that is much smaller than the input.
void ErrorLimitedRun::make_coarse_bound(const WorkingSurface& start) {
  constexpr double share_of_limit = 0.06;  // three times that of a contraction, as several add up
  if (start.is_input() || 2 * start.faces.size() > run_.mesh().faces.size() || run_.is_cancelled()) return;
  const double limit = (1 - share_of_limit) * error_bounds_->surface().limit();
  coarse_bound_ = std::make_unique<ErrorBound>(surface_of(start), Frame{}, limit, run_.options().threads);
}

/// Contracts what keeps the bounds. Faces move to points of the input that are too far in the end; if that doesn't
/// help, these points are looked at, too. A coarse bound is made smaller if the surface is too far from the input. \pre
/// find_violations_before_guarding().empty() \return whether what is left is proven to be near to the input, or the run
/// is cancelled; otherwise it is as it was
bool ErrorLimitedRun::contract_guarded() {
  constexpr int most_tries = 12;
  const StagedRun::State before = run_.state();
  const StageLimits limits{.error_bound = &guarding_bound(), .border_bound = error_bounds_->borders()};
  for (int i = 0; i < most_tries; ++i) {
    if (run_.is_cancelled()) return true;
    if (i > 0 && !find_violations_before_guarding().empty()) return false;
    run_.contract(target(), true, limits);
    if (run_.is_cancelled()) return true;
    const IndexedMesh surface = surface_of(left());
    // The guard has proven each face, unless it compared with a coarse copy.
    const std::vector<std::uint8_t> is_proven(surface.faces.size(), coarse_bound_ ? 0 : 1);
    const CheckedSurface checked{surface, Frame{}, left().vertex_map, is_proven};
    ErrorBound& exact = error_bounds_->surface();
    const ErrorBound::Violations violations = exact.check(checked, exact.limit());
    const ErrorBound::Violations of_borders = error_bounds_->check_borders(checked);
    if (violations.empty() && of_borders.empty()) return true;
    if (of_borders.empty() && move_to_far_points(surface, violations)) return true;
    run_.return_to(before);
    if (of_borders.is_surface_far || (violations.is_surface_far && !coarse_bound_)) return false;
    if (violations.is_surface_far) coarse_bound_->tighten();
    guarding_bound().add_points(violations.points);
    if (error_bounds_->borders() != nullptr) error_bounds_->borders()->add_points(of_borders.points);
  }
  return false;
}

/// Whether vertices need be nowhere but near to the input.
bool ErrorLimitedRun::may_move_vertices() const {
  const DecimateOptions& options = run_.options();
  const bool has_lines = options.feature_angle_deg.value_or(180) < 180 || !options.feature_edges.empty();
  return options.locked.empty() && options.boundary != Boundary::locked && !has_lines && !options.min_radius_ratio &&
         !options.refuse_intersections && places_anywhere(options);
}

/// Moves faces towards points of the input that are little too far from them: mostly there are one or two.
/// \return whether what is left is proven then. Otherwise all is as it was
bool ErrorLimitedRun::move_to_far_points(IndexedMesh surface, ErrorBound::Violations violations) {
  constexpr int most_tries = 3;
  constexpr double share_of_limit = 0.98;
  ErrorBound& exact = error_bounds_->surface();
  if (!may_move_vertices()) return false;
  for (int i = 0; i < most_tries && !violations.is_surface_far && !violations.points.empty(); ++i) {
    const TargetSurface target(surface, Frame{});
    std::vector<std::uint8_t> is_changed(surface.positions.size());
    for (const ErrorBound::FarPoint& far : violations.points) {
      const Index face = target.nearest(far.position, invalid_index).face;
      const Corners corners = target.faces().corners(face);
      const auto& [a, b, c] = corners;
      const Barycentric at = nearest_on_triangle(a - far.position, b - far.position, c - far.position);
      const Vec3 way = far.position - point_at(corners, at);
      for (const Index v : surface.faces[face]) {
        surface.positions[v] += (1 - std::min(1.0, share_of_limit * far.limit / way.norm())) * way;
        is_changed[v] = 1;
      }
    }
    violations = exact.check_again({surface, Frame{}, left().vertex_map}, is_changed);
  }
  if (!violations.empty() || !error_bounds_->check_borders({surface, Frame{}, left().vertex_map}).empty()) return false;
  run_.move_vertices(std::move(surface.positions));
  return true;
}

/// The guards look at the supports that are found with them.
ErrorBound::Violations ErrorLimitedRun::find_violations_before_guarding() {
  if (run_.is_cancelled()) return {};
  const IndexedMesh surface = surface_of(left());
  const CheckedSurface checked{surface, Frame{}, left().vertex_map};
  if (!coarse_bound_) return error_bounds_->check(checked);
  const std::vector<Index> map = map_from_start();
  ErrorBound::Violations violations = coarse_bound_->check({surface, Frame{}, map}, coarse_bound_->limit());
  violations.add(error_bounds_->check_borders(checked));
  return violations;
}

/// Tells what stands. \return what the proofs were made with
std::unique_ptr<ErrorBounds> ErrorLimitedRun::end() {
  DecimateResult& result = run_.report().result;
  if (run_.options().listener) {
    for (const Contraction& contraction : run_.report().steps.contractions) run_.options().listener(contraction);
  }
  if (!run_.is_cancelled()) result.proven_error = target().error_limit();
  if (result.stop == StopReason::exhausted && result.refused_at_end[Refusal::error] > 0)
    result.stop = StopReason::error;
  return std::move(error_bounds_);
}

}  // namespace whittle
