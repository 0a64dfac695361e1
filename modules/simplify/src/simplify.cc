#include "whittle/simplify/simplify.hh"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cost_comparison.hh"
#include "decimation_polisher.hh"
#include "effort.hh"
#include "simplify_sheets.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/progress.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/engine/detail/decimate_and_fit.hh"
#include "whittle/engine/two_sided_sheets.hh"
#include "whittle/polish/fit_attributes.hh"

namespace whittle {
namespace {

void break_normals_of(const IndexedMesh& input, const SimplifyOptions& options, Decimation& decimation) {
  const DecimateOptions& decimate = options.decimate;
  break_normals(Frame::of_points(input.positions), decimate.normals, decimate.crease_angle_deg, decimation.mesh);
}

/// \pre all options are settled
Simplification simplify_as_settled(const IndexedMesh& mesh, const DecimateTarget& target, SimplifyOptions settled,
                                   DecimationPolisher& polisher) {
  const Stopwatch watch;
  double polish_seconds = 0;
  SimplifyOptions without_flips = settled;
  without_flips.flips = false;
  if (!settled.pauses->empty()) {
    settled.decimate.pauses = {*settled.pauses, [&](Decimation& paused) {
                                 const Stopwatch polishing;
                                 const PolishResult polish = polisher.polish(without_flips, paused);
                                 polish_seconds += polishing.seconds();
                                 return !polish.cancelled;
                               }};
  }
  PolishResult polish;
  std::optional<Stopwatch> fitting;
  detail::Fit fit;
  if (settled.polish_passes > 0U) {
    fit = [&](Decimation& decimation) {
      if (!fitting) fitting.emplace();
      polish = polisher.polish(settled, decimation);
      return !polish.cancelled;
    };
  }
  detail::FittedDecimation fitted = detail::decimate_and_fit(mesh, target, settled.decimate, fit);
  Simplification result{std::move(fitted.decimation), *settled.decimate.cost, {}, 0, 0, 0};
  if (fitted.is_fitted || polish.cancelled) result.polish = polish;
  if (fitting) polish_seconds += fitting->seconds();
  result.polish_seconds = polish_seconds;
  result.decimate_seconds = watch.seconds() - polish_seconds;
  return result;
}

/// Whether `other` is to be taken instead: it alone has reached the target, or it has and is nearer.
bool is_better(const IndexedMesh& input, const Simplification& other, const Simplification& result) {
  const bool is_reached = result.result.stop == StopReason::target;
  const bool is_other_reached = other.result.stop == StopReason::target;
  if (is_reached != is_other_reached) return is_other_reached;
  return is_nearer(input, other.mesh, result.mesh);
}

void finish_attributes_of(const IndexedMesh& input, const SimplifyOptions& settled, Simplification& result) {
  fit_attributes_of(input, settled, result);
  break_normals_of(input, settled, result);
}

bool is_cancelled(const Simplification& result) {
  return result.result.stop == StopReason::cancelled || result.polish.cancelled;
}

/// Simplifies with one cost, and then, if that wasn't cancelled, with another one.
std::vector<Simplification> simplify_twice(const IndexedMesh& mesh, const DecimateTarget& target,
                                           const SimplifyOptions& settled, const SimplifyOptions& other,
                                           DecimationPolisher& polisher) {
  std::vector<Simplification> both{simplify_as_settled(mesh, target, settled, polisher)};
  if (!is_cancelled(both.front())) both.push_back(simplify_as_settled(mesh, target, other, polisher));
  return both;
}

/// The same at once, each on half of the threads. Progress is that of the first, on the calling thread.
std::vector<Simplification> simplify_twice_at_once(const IndexedMesh& mesh, const DecimateTarget& target,
                                                   SimplifyOptions settled, SimplifyOptions other,
                                                   DecimationPolisher& polisher) {
  const auto n = static_cast<unsigned>(n_threads(settled.decimate.threads));
  settled.decimate.threads = n - n / 2;
  other.decimate.threads = n / 2;
  std::vector<Simplification> both;
  std::optional<Simplification> second;
  std::exception_ptr failure;
  std::jthread thread([&](const std::stop_token& stop) {
    other.decimate.progress = [&stop](const Progress&) { return !stop.stop_requested(); };
    try {
      second = simplify_as_settled(mesh, target, other, polisher);
    } catch (...) {
      failure = std::current_exception();
    }
  });
  both.push_back(simplify_as_settled(mesh, target, settled, polisher));
  if (is_cancelled(both.front())) return both;
  thread.join();
  if (failure) std::rethrow_exception(failure);
  both.push_back(std::move(*second));
  return both;
}

/// With plain quadrics and without, where both are tried.
Simplification better_of_both(const IndexedMesh& mesh, const DecimateTarget& target, const SimplifyOptions& settled,
                              DecimationPolisher& polisher) {
  if (!*settled.tries_plain_quadrics || !is_worth_plain_quadrics(mesh, target)) {
    return simplify_as_settled(mesh, target, settled, polisher);
  }
  const Stopwatch watch;
  SimplifyOptions plain = settled;
  plain.decimate.cost = Cost::quadric;
  const bool is_at_once = n_threads(settled.decimate.threads) > 1;
  std::vector<Simplification> both = is_at_once ? simplify_twice_at_once(mesh, target, settled, plain, polisher)
                                                : simplify_twice(mesh, target, settled, plain, polisher);
  if (both.size() == 1) return std::move(both.front());
  Simplification& better = is_better(mesh, both[1], both[0]) ? both[1] : both[0];
  const double contracting = both[0].decimate_seconds + both[1].decimate_seconds;
  const double polishing = both[0].polish_seconds + both[1].polish_seconds;
  better.decimate_seconds = watch.seconds() * contracting / (contracting + polishing);
  better.polish_seconds = watch.seconds() - better.decimate_seconds;
  return std::move(better);
}

}  // namespace

PolishResult polish_decimation(const IndexedMesh& original, const SimplifyOptions& options, Decimation& decimation) {
  const PolishResult result = DecimationPolisher(original).polish(options, decimation);
  break_normals_of(original, options, decimation);
  return result;
}

void fit_attributes_of(const IndexedMesh& original, const SimplifyOptions& options, Simplification& result) {
  if (is_cancelled(result) || options.polish_passes == 0U) return;
  const Stopwatch watch;
  const AttributeFitReport report =
      fit_attributes(original, wedge_map(original, result.vertex_map, result.face_origins), result.mesh,
                     {options.decimate.normals == Normals::keep, options.decimate.threads});
  result.n_folded_texture_faces = report.n_folded_faces;
  result.steps.fits_attributes = true;
  result.polish_seconds += watch.seconds();
}

Simplification simplify(const IndexedMesh& mesh, const DecimateTarget& target, Effort effort,
                        const SimplifyOptions& options) {
  if (const TwoSidedSheets sheets(mesh, options.decimate.threads); sheets.any())
    return simplify_sheets(sheets, target, effort, options);
  const SimplifyOptions settled = with_effort_on_one_side(effort, options, mesh, target);
  DecimationPolisher polisher(mesh);
  Simplification result = better_of_both(mesh, target, settled, polisher);
  finish_attributes_of(mesh, settled, result);
  return result;
}

namespace {

std::uint64_t count_of(const DecimateTarget& target) {
  return target.n_faces().value_or(target.n_vertices().value_or(0));
}

/// \throw std::invalid_argument
void check_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets, const SimplifyOptions& options) {
  const auto require = [](bool is_so, const char* what) {
    if (!is_so) throw std::invalid_argument(std::string("simplify_to_levels: ") + what);
  };
  require(!targets.empty(), "there is no target");
  require(options.decimate.pauses.at.empty() && !options.pauses, "pauses don't go with levels");
  const bool has_faces = targets.front().n_faces().has_value();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const DecimateTarget& target = targets[i];
    require(target.n_faces().has_value() == has_faces && target.n_vertices().has_value() != has_faces,
            "a target is no count, or counts are not all of one kind");
    require(!target.cost_limit() && !target.error_limit(), "a target limits the cost or the error");
    require(i == 0 || count_of(target) < count_of(targets[i - 1]), "targets are not in descending order");
  }
  require(count_of(targets.front()) < (has_faces ? mesh.faces.size() : mesh.positions.size()),
          "the mesh has reached a target");
}

/// No run gets below 1: the levels to 0 are those to 1, with another reason for the stop.
std::vector<Simplification> levels_to_zero(const IndexedMesh& mesh, std::vector<DecimateTarget> targets, Effort effort,
                                           const SimplifyOptions& options) {
  const auto one = targets.back().n_faces() ? DecimateTarget::faces(1) : DecimateTarget::vertices(1);
  targets.pop_back();
  const bool has_one = !targets.empty() && count_of(targets.back()) == 1;
  if (!has_one) targets.push_back(one);
  std::vector<Simplification> levels = simplify_to_levels(mesh, targets, effort, options);
  if (levels.back().result.stop != StopReason::target) return levels;
  if (has_one) levels.push_back(levels.back());
  levels.back().result.stop = StopReason::exhausted;
  return levels;
}

/// Multiples of the last target's count that come to the counts of the others, rounded up.
std::vector<double> pauses_at(const std::vector<DecimateTarget>& targets) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
    at.push_back((static_cast<double>(count_of(targets[i])) - 0.5) / static_cast<double>(count_of(targets.back())));
  }
  return at;
}

}  // namespace

std::vector<Simplification> simplify_to_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets,
                                               Effort effort, const SimplifyOptions& options) {
  check_levels(mesh, targets, options);
  if (const TwoSidedSheets sheets(mesh, options.decimate.threads); sheets.any())
    return simplify_sheets_to_levels(sheets, targets, effort, options);
  if (count_of(targets.back()) == 0) return levels_to_zero(mesh, targets, effort, options);
  SimplifyOptions settled = with_effort_on_one_side(effort, options, mesh, targets.front());
  settled.pauses->clear();
  SimplifyOptions without_flips = settled;
  without_flips.flips = false;
  DecimationPolisher polisher(mesh);
  const Frame frame = Frame::of_points(mesh.positions);
  std::vector<Simplification> levels;
  double polish_seconds = 0;
  const auto add_level = [&](Decimation& paused) {
    const Stopwatch watch;
    const PolishResult polish = polisher.polish(without_flips, paused);
    polish_seconds += watch.seconds();
    levels.push_back({paused, *settled.decimate.cost, polish, 0, 0, 0});
    Decimation& level = levels.back();
    carry_attributes(mesh, frame, settled.decimate.normals, level.vertex_map, level.face_origins, level.mesh,
                     settled.decimate.threads, settled.polish_passes == 0U);
    finish_attributes_of(mesh, settled, levels.back());
    return !polish.cancelled;
  };
  settled.decimate.pauses = {pauses_at(targets), add_level};
  levels.push_back(simplify_as_settled(mesh, targets.back(), settled, polisher));
  finish_attributes_of(mesh, settled, levels.back());
  levels.back().decimate_seconds -= polish_seconds;
  levels.back().polish_seconds += polish_seconds;
  return levels;
}

}  // namespace whittle
