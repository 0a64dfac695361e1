#pragma once

#include <optional>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/engine/decimate_target.hh"
#include "whittle/engine/options.hh"
#include "whittle/engine/two_sided_sheets.hh"

namespace whittle::detail {

/// Targets for a mesh without backs at which it has as many faces, with its backs, as others ask for. Where some faces
/// have no back, a run with options is made to find out: the targets are exact for the same run.
/// \param options of the mesh without backs; pauses and limits of the error don't count
std::vector<DecimateTarget> targets_without_backs(const TwoSidedSheets& sheets,
                                                  const std::vector<DecimateTarget>& targets, DecimateOptions options);

/// The next target to try, where one has left more faces with their backs than are asked for; none if it hasn't.
/// \param tried without backs \param face_origins of what it has left
std::optional<DecimateTarget> lower_target_without_backs(const TwoSidedSheets& sheets, const DecimateTarget& asked,
                                                         const DecimateTarget& tried,
                                                         const std::vector<Index>& face_origins);

/// Runs on a mesh without backs, and adds them to the result.
/// \param run makes a decimation for a target and options. It is called again where other targets leave too many faces
template <class Run>
auto run_without_backs(const TwoSidedSheets& sheets, const DecimateTarget& target, const DecimateOptions& options,
                       const Run& run) {
  DecimateOptions own = sheets.options_without_backs(options);
  own.listener = {};
  own.keep_steps = options.keep_steps || options.listener;
  DecimateTarget own_target = targets_without_backs(sheets, {target}, own).front();
  auto result = run(own_target, own);
  while (const auto lower = lower_target_without_backs(sheets, target, own_target, result.face_origins)) {
    if (result.result.stop != StopReason::target) break;
    own_target = *lower;
    result = run(own_target, own);
  }
  if (options.listener) {
    for (const Contraction& contraction : result.steps.contractions) options.listener(contraction);
  }
  if (!options.keep_steps) result.steps = {};
  sheets.add_backs(options.normals, options.threads, result);
  return result;
}

}  // namespace whittle::detail
