#include "simplify_sheets.hh"

#include <algorithm>
#include <utility>

#include "whittle/engine/detail/without_backs.hh"

namespace whittle {
namespace {

/// Options with the cost by effort for the mesh without backs, which has fewer faces.
DecimateOptions with_cost(const TwoSidedSheets& sheets, const DecimateTarget& target, Effort effort,
                          const SimplifyOptions& options) {
  return with_effort(effort, options, sheets.without_backs(), target).decimate;
}

/// Targets without repetitions of the count before.
std::vector<DecimateTarget> with_different_counts(const std::vector<DecimateTarget>& targets) {
  std::vector<DecimateTarget> different = targets;
  const auto have_same_count = [](const DecimateTarget& a, const DecimateTarget& b) {
    return a.n_faces() == b.n_faces() && a.n_vertices() == b.n_vertices();
  };
  different.erase(std::unique(different.begin(), different.end(), have_same_count), different.end());
  return different;
}

/// A level for each target; targets of equal counts share one. Fewer if the run ended early.
std::vector<Simplification> levels_at(const std::vector<DecimateTarget>& targets,
                                      const std::vector<DecimateTarget>& different,
                                      const std::vector<Simplification>& levels) {
  std::vector<Simplification> all;
  std::size_t i = 0;
  for (const DecimateTarget& target : targets) {
    while (i < levels.size() &&
           (different[i].n_faces() != target.n_faces() || different[i].n_vertices() != target.n_vertices()))
      ++i;
    if (i < levels.size()) all.push_back(levels[i]);
  }
  return all;
}

/// Lowers counts that leave too many faces. \return whether any was lowered
bool lower_targets(const TwoSidedSheets& sheets, const std::vector<DecimateTarget>& asked,
                   const std::vector<Simplification>& levels, std::vector<DecimateTarget>& tried) {
  bool is_any_lower = false;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].result.stop == StopReason::exhausted || levels[i].result.stop == StopReason::cancelled) continue;
    const auto lower = detail::lower_target_without_backs(sheets, asked[i], tried[i], levels[i].face_origins);
    if (!lower) continue;
    tried[i] = *lower;
    is_any_lower = true;
  }
  for (std::size_t i = 1; i < tried.size(); ++i) {
    if (tried[i].n_faces() > tried[i - 1].n_faces()) tried[i] = tried[i - 1];
  }
  return is_any_lower;
}

}  // namespace

Simplification simplify_sheets(const TwoSidedSheets& sheets, const DecimateTarget& target, Effort effort,
                               const SimplifyOptions& options) {
  SimplifyOptions own = options;
  own.decimate.cost = with_cost(sheets, target, effort, options).cost;
  return detail::run_without_backs(sheets, target, own.decimate,
                                   [&](const DecimateTarget& own_target, const DecimateOptions& own_options) {
                                     SimplifyOptions without_backs = options;
                                     without_backs.decimate = own_options;
                                     without_backs.decimate.cost = options.decimate.cost;
                                     return simplify(sheets.without_backs(), own_target, effort, without_backs);
                                   });
}

std::vector<Simplification> simplify_sheets_to_levels(const TwoSidedSheets& sheets,
                                                      const std::vector<DecimateTarget>& targets, Effort effort,
                                                      const SimplifyOptions& options) {
  SimplifyOptions own = options;
  own.decimate = sheets.options_without_backs(options.decimate);
  std::vector<DecimateTarget> own_targets = detail::targets_without_backs(
      sheets, targets, sheets.options_without_backs(with_cost(sheets, targets.back(), effort, options)));
  std::vector<Simplification> levels;
  do {
    const std::vector<DecimateTarget> different = with_different_counts(own_targets);
    levels = levels_at(own_targets, different, simplify_to_levels(sheets.without_backs(), different, effort, own));
  } while (lower_targets(sheets, targets, levels, own_targets));
  for (Simplification& level : levels) sheets.add_backs(options.decimate.normals, options.decimate.threads, level);
  return levels;
}

}  // namespace whittle
