#include "decimate/run.hh"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "decimate/checks.hh"
#include "decimate/error_limited_run.hh"
#include "decimate/passes.hh"

namespace whittle {
namespace {

/// The first pause, if blocks would go beyond it on the way to the target.
DecimateTarget target_of_blocks(const Passes& passes, const BlockPlan& plan) {
  const std::vector<double>& pauses = passes.options().pauses.at;
  const bool is_early = !pauses.empty() && pauses.front() > plan.surplus;
  return is_early ? passes.target().with_counts_times(pauses.front()) : passes.target();
}

/// Contracts in blocks where that is worth while, and then to each stop in turn.
void contract_to_stops(Passes& passes, const BlockPlan& plan) {
  std::string_view why_in_one_pass = passes.contract_in_blocks(target_of_blocks(passes, plan), plan);
  const std::vector<DecimateTarget> stops = passes.stops();
  const auto contract_to_stop = [&](std::size_t i) { passes.contract_to(stops[i], i + 1 == stops.size()); };
  contract_to_stop(0);
  if (passes.is_beyond_target()) {
    why_in_one_pass = "blocks went beyond the target";
    passes.forget_all();
    contract_to_stop(0);
  }
  for (std::size_t i = 1; i < stops.size() && passes.done().result.stop == StopReason::target; ++i) {
    if (passes.adjust()) {
      contract_to_stop(i);
    } else {
      passes.done().result.stop = StopReason::cancelled;
    }
  }
  passes.done().result.why_in_one_pass = why_in_one_pass;
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
  Passes passes(mesh, target, options, host);
  const bool has_faces = std::any_of(mesh.faces.begin(), mesh.faces.end(), has_three_corners);
  if (target.error_limit() && has_faces) {
    std::unique_ptr<ErrorBounds> bounds = ErrorLimitedRun(passes).contract(plan);
    if (error_bounds != nullptr) *error_bounds = std::move(bounds);
    passes.done().result.why_in_one_pass = why_not_in_blocks(mesh, target, options, host, plan);
  } else {
    contract_to_stops(passes, plan);
  }
  return passes.output(keeps_in_charts);
}

}  // namespace whittle
