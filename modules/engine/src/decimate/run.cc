#include "decimate/run.hh"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "decimate/checks.hh"
#include "decimate/error_limited_run.hh"
#include "decimate/staged_run.hh"

namespace whittle {
namespace {

/// Where blocks stop: at the first checkpoint, or short of the target, if no checkpoint comes before.
DecimateTarget target_of_blocks(const StagedRun& run, const DecimateTarget& first_stop, const BlockPlan& plan) {
  const std::vector<double>& checkpoints = run.options().pauses.at;
  const bool is_early = !checkpoints.empty() && checkpoints.front() > plan.surplus;
  return is_early || goes_to_target(run.options()) ? first_stop : run.target();
}

/// Whether blocks may have made contractions in exact order that come after the last one.
bool is_beyond_target(const DecimateResult& in_blocks, const DecimateResult& after) {
  return in_blocks.why_in_one_pass.empty() && after.stop == StopReason::target &&
         !(in_blocks.max_cost < after.max_cost);
}

/// Contracts anew in blocks, which keep parts, as far as none of these need vanish. In exact order a part might vanish
/// before what blocks contract.
DecimateResult contract_again_in_blocks(StagedRun& run, const BlockPlan& plan) {
  run.begin_anew(run.report().progress);
  if (!is_exact_in_blocks(run.options())) return run.contract_in_blocks(run.target_with_parts(), plan);
  run.report().result.why_in_one_pass = "parts may vanish";
  return run.report().result;
}

/// Contracts in blocks where that is worth while, and then to each checkpoint in turn.
void contract_to_target(StagedRun& run, const BlockPlan& plan) {
  const std::vector<DecimateTarget> all_stops = run.stops();
  DecimateResult in_blocks = run.contract_in_blocks(target_of_blocks(run, all_stops.front(), plan), plan);
  const bool has_blocks = in_blocks.why_in_one_pass.empty() && !run.is_cancelled();
  const bool may_parts_vanish = has_blocks && run.topology() == Topology::automatic;
  if (may_parts_vanish) in_blocks = contract_again_in_blocks(run, plan);
  const bool goes_on_in_rounds = !may_parts_vanish && in_blocks.why_in_one_pass.empty() &&
                                 goes_to_target(run.options()) &&
                                 is_nearly_manifold(in_blocks.before, all_stops.front(), run.mesh());
  const std::vector<DecimateTarget> stops = goes_on_in_rounds ? all_stops : run.stops();
  const auto contract_to_stop = [&](std::size_t i) { return run.contract(stops[i], i + 1 == stops.size()); };
  const DecimateResult first = contract_to_stop(0);
  if (is_exact_in_blocks(run.options()) && is_beyond_target(in_blocks, first)) {
    run.begin_anew(1);
    run.report().result.why_in_one_pass = "blocks went beyond the target";
    contract_to_stop(0);
  }
  for (std::size_t i = 1; i < stops.size() && run.report().result.stop == StopReason::target; ++i) {
    if (run.checkpoint()) {
      if (goes_on_in_rounds) run.contract_in_blocks(stops[i], plan);
      contract_to_stop(i);
    } else {
      run.report().result.stop = StopReason::cancelled;
    }
  }
}

}  // namespace

Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan, std::unique_ptr<ErrorBounds>* error_bounds,
               bool keeps_in_charts) {
  check(target, options, mesh.positions.size());
  check(mesh);
  if (host != nullptr && !options.pauses.at.empty()) {
    throw std::invalid_argument("decimate: pauses don't go with a host");
  }
  if (host != nullptr && target.error_limit()) {
    throw std::invalid_argument("decimate: max_error doesn't go with a host");
  }
  StagedRun stages(mesh, target, options, host);
  const bool has_faces = std::any_of(mesh.faces.begin(), mesh.faces.end(), has_three_corners);
  if (target.error_limit() && has_faces) {
    std::unique_ptr<ErrorBounds> bounds = ErrorLimitedRun(stages).contract(plan);
    if (error_bounds != nullptr) *error_bounds = std::move(bounds);
    stages.report().result.why_in_one_pass = why_not_in_blocks(mesh, target, options, host, plan, false);
  } else {
    contract_to_target(stages, plan);
  }
  return stages.finish(keeps_in_charts);
}

}  // namespace whittle
