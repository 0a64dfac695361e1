#include "whittle/pipeline/run.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "run/observe.hh"
#include "run/per_mesh.hh"
#include "run/proof.hh"
#include "run/run_warnings.hh"
#include "run/shortfall.hh"
#include "run/vanished.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/text/text.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {
namespace {

/// By the plan's decimater in place of ours.
Simplification simplify_elsewhere(const Plan& plan, const DecimateTarget& target, const SimplifyOptions& options) {
  const Stopwatch decimating;
  Simplification result{
      plan.request.decimater(plan.scene, target, options.decimate), options.decimate.effective_cost(), {}, 0, 0};
  result.decimate_seconds = decimating.seconds();
  const Stopwatch polishing;
  result.polish = polish_decimation(plan.scene.read.mesh, options, result);
  result.polish_seconds = polishing.seconds();
  return result;
}

/// \throw Cancelled
Simplification simplify_to(const Plan& plan, const DecimateTarget& target, SimplifyOptions options,
                           const RunObserver& observer) {
  bool is_cancelled = false;
  if (observer) {
    options.decimate.progress = [&](const Progress& progress) {
      const bool goes_on = observer(run_progress(progress));
      is_cancelled = is_cancelled || !goes_on;
      return goes_on;
    };
  }
  const Effort effort = plan.request.effort;
  Simplification result = plan.request.decimater ? simplify_elsewhere(plan, target, options)
                          : plan.request.is_per_mesh
                              ? simplify_per_mesh(plan.scene, plan.targets_per_mesh, effort, options)
                              : simplify(plan.scene.read.mesh, target, effort, options);
  if (is_cancelled) throw Cancelled();
  return result;
}

void take(Simplification result, Outcome& outcome) {
  outcome.seconds.decimate += result.decimate_seconds;
  outcome.seconds.polish += result.polish_seconds;
  outcome.simplified = std::move(result);
}

/// Takes over a result. \return whether it keeps the limits of the error as it is written, which is proven
bool take_if_within(Simplification result, const Plan& plan, const RunObserver& observer, Outcome& outcome) {
  const Stopwatch watch;
  outcome.distances = distances_as_written(plan, result, observer);
  const bool is_kept = outcome.distances && keep_limits(plan, *outcome.distances);
  outcome.seconds.certify += watch.seconds();
  take(std::move(result), outcome);
  return is_kept;
}

/// The scene as it is.
Simplification uncontracted(const Plan& plan, const RunObserver& observer) {
  SimplifyOptions options = plan.options;
  options.polish_passes = 0;
  options.decimate.tolerances.clear();  // they go with a limit of the error
  Simplification result =
      simplify_to(plan, DecimateTarget::faces(plan.scene.read.mesh.faces.size()), options, observer);
  result.result.stop = StopReason::error;
  return result;
}

double at_least(const metrics::LargestDistances& distances) {
  return std::max(distances.forward.at_least, distances.backward.at_least);
}

/// What stands in the way of a limit that not even the scene itself keeps.
std::string why_not_uncontracted(const Plan& plan, const DistancesAsWritten& distances) {
  if (const double off = at_least(distances.surface); off > *plan.target.error_limit()) {
    const SceneOutput& output = plan.request.output;
    return "rounding moves them by " + significant(off) + "; choose a larger --max-error, or " +
           (output.gltf.rounds() ? "leave out " + rounding_options(output.gltf) : "a format that keeps every digit");
  }
  const double off = distances.borders ? at_least(*distances.borders) : 0;
  if (off <= *plan.target.border_error_limit()) return "choose a larger --max-error";
  return "open borders are " + (std::isfinite(off) ? significant(off) + " off" : std::string("gone, or new,")) +
         " as it is read again; choose a larger --max-error-borders";
}

std::string why_not_within(const Plan& plan, const Outcome& outcome) {
  return plan.scene.name + ": an error of " + shortest(*plan.target.error_limit()) + " at most can't be proven as " +
         name_of(plan.request.output) + " would be written, not even of all faces of the input; " +
         (outcome.distances ? why_not_uncontracted(plan, *outcome.distances) : "choose a larger --max-error");
}

/// Keeps to the largest error as the result is written: if rounding takes it over that, tries again with less. The
/// scene itself is the last that is tried.
void simplify_within_error(const Plan& plan, const RunObserver& observer, Outcome& outcome) {
  const double limit = *plan.target.error_limit() / plan.stretch;
  const double border_limit = *plan.target.border_error_limit() / plan.stretch;
  for (const double share : {1 - 1e-6, 0.99, 0.9, 0.5}) {
    SimplifyOptions options = plan.options;
    for (double& tolerance : options.decimate.tolerances) tolerance *= share;
    const DecimateTarget target = plan.target.or_max_error(share * limit, share * border_limit);
    if (take_if_within(simplify_to(plan, target, std::move(options), observer), plan, observer, outcome)) return;
  }
  if (take_if_within(uncontracted(plan, observer), plan, observer, outcome)) return;
  throw std::runtime_error(why_not_within(plan, outcome));
}

void simplify_without_limit(const Plan& plan, const RunObserver& observer, Outcome& outcome) {
  take(simplify_to(plan, plan.target, plan.options, observer), outcome);
  if (!plan.request.proves()) return;
  const Stopwatch watch;
  outcome.distances = distances_as_written(plan, outcome.simplified, observer);
  outcome.seconds.certify = watch.seconds();
}

void make_certificate(const Plan& plan, const RunObserver& observer, Outcome& outcome) {
  if (!plan.request.makes_certificate) return;
  if (!outcome.distances) throw std::runtime_error(plan.scene.name + ": no face is left to write a certificate of");
  const Stopwatch watch;
  outcome.certificate = certificate_as_written(plan, *outcome.distances, observer);
  outcome.seconds.certify += watch.seconds();
}

void count_intersections(const Plan& plan, const RunObserver& observer, Outcome& outcome) {
  if (plan.request.self_intersections == SelfIntersections::allow) return;
  const auto count = [&](const IndexedMesh& mesh, double from, double to) {
    if (mesh.faces.empty()) return std::size_t{0};
    return metrics::self_intersections(mesh, plan.threads(), observed(observer, "counting intersections", from, to))
        .size();
  };
  outcome.n_intersections_before = count(plan.scene.read.mesh, 0, 0.8);
  outcome.n_intersections_after = count(outcome.simplified.mesh, 0.8, 1);
}

/// What becomes of a scene without faces: all of it stays as it is.
Outcome outcome_without_faces(const Plan& plan) {
  Outcome outcome;
  outcome.simplified.cost = plan.options.decimate.effective_cost();
  outcome.simplified.result.stop = plan.target.is_reached_at(0, 0) ? StopReason::target : StopReason::exhausted;
  outcome.met = is_met(plan.target, outcome.simplified.result.stop);
  outcome.warnings.push_back({RunWarningKind::no_triangles,
                              about(plan.scene.name, why_no_faces(plan.scene.read) +
                                                         "; there is nothing to simplify, and all of it is written as "
                                                         "it was")});
  return outcome;
}

}  // namespace

Outcome run(const Plan& plan, const RunObserver& observer) {
  if (!plan.has_faces()) return outcome_without_faces(plan);
  Outcome outcome;
  if (plan.target.error_limit()) {
    simplify_within_error(plan, observer, outcome);
  } else {
    simplify_without_limit(plan, observer, outcome);
  }
  make_certificate(plan, observer, outcome);
  outcome.met = is_met(plan.target, outcome.simplified.result.stop);
  if (!outcome.met) outcome.shortfall = find_shortfall(plan, outcome.simplified);
  outcome.vanished = find_vanished(plan.scene, outcome.simplified, plan.options.decimate.regions);
  outcome.warnings = find_warnings(plan, outcome);
  count_intersections(plan, observer, outcome);
  return outcome;
}

}  // namespace whittle
