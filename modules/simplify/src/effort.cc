#include "effort.hh"

#include <utility>
#include <vector>

#include "whittle/engine/two_sided_sheets.hh"

namespace whittle {
namespace {

/// Whether an option excludes memoryless quadrics.
bool needs_plain_quadrics(const DecimateOptions& options) {
  const CostConflicts& why_not = cost_traits(Cost::memoryless).why_not;
  const bool has_exact_pairs = options.pairs.threshold > 0 && options.order == Order::exact;
  return (options.isotropy > 0 && !why_not.isotropy.empty()) ||
         (options.quadric.weights != Weights::area && !why_not.weights.empty()) ||
         (has_exact_pairs && !why_not.threshold_in_exact_order.empty());
}

Cost cost_by_effort(Effort effort, const DecimateOptions& options) {
  return effort == Effort::fast || needs_plain_quadrics(options) ? Cost::quadric : Cost::memoryless;
}

unsigned passes_by_effort(Effort effort, const SimplifyOptions& options) {
  if (effort == Effort::fast || options.decimate.quadric.placement != Placement::optimal) return 0;
  return effort == Effort::best || options.fit == Fit::max ? 2 : 1;
}

/// Whether memoryless quadrics are quick. Whether contractions are told makes no difference.
bool memoryless_goes_in_blocks(const IndexedMesh& mesh, const DecimateTarget& target, DecimateOptions options) {
  if (options.cost || needs_plain_quadrics(options)) return false;
  options.cost = Cost::memoryless;
  options.listener = {};
  options.keep_steps = false;
  return goes_in_blocks(mesh, target, options);
}

std::vector<double> pauses_by_effort(Effort effort, const DecimateOptions& options) {
  if (effort == Effort::fast || options.quadric.placement == Placement::endpoint) return {};
  return effort == Effort::best ? std::vector<double>{1.2, 1.1, 1.03} : std::vector<double>{1.1};
}

}  // namespace

SimplifyOptions with_effort(Effort effort, SimplifyOptions options) {
  const DecimateOptions& decimate = options.decimate;
  const bool is_cost_by_effort = !decimate.cost;
  options.decimate.cost = decimate.cost.value_or(cost_by_effort(effort, decimate));
  options.decimate.hold_folds = decimate.hold_folds.value_or(true);
  options.polish_passes = options.polish_passes.value_or(passes_by_effort(effort, options));
  options.flips = options.flips.value_or(effort == Effort::best);
  options.tries_plain_quadrics =
      options.tries_plain_quadrics.value_or(is_cost_by_effort && options.decimate.cost == Cost::memoryless &&
                                            effort != Effort::fast && !decimate.listener && decimate.pauses.at.empty());
  const bool has_pauses = options.polish_passes > 0U && decimate.pauses.at.empty();
  options.pauses = has_pauses ? options.pauses.value_or(pauses_by_effort(effort, decimate)) : std::vector<double>{};
  return options;
}

namespace {

SimplifyOptions with_effort(Effort effort, SimplifyOptions options, const DecimateTarget& target,
                            bool is_memoryless_quick) {
  if (is_memoryless_quick) options.decimate.cost = Cost::memoryless;
  if (target.error_limit()) options.flips = false;
  const bool has_count = target.n_faces() || target.n_vertices();
  if (!has_count || target.error_limit()) options.pauses = std::vector<double>{};
  return with_effort(effort, std::move(options));
}

}  // namespace

SimplifyOptions with_effort_on_one_side(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                                        const DecimateTarget& target) {
  const bool is_quick = memoryless_goes_in_blocks(mesh, target, options.decimate);
  return with_effort(effort, std::move(options), target, is_quick);
}

SimplifyOptions with_effort(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                            const DecimateTarget& target) {
  bool is_quick = memoryless_goes_in_blocks(mesh, target, options.decimate);
  if (is_quick) {  // the engine leaves out the backs of two-sided sheets
    const TwoSidedSheets sheets(mesh, options.decimate.threads);
    is_quick = !sheets.any() || memoryless_goes_in_blocks(sheets.without_backs(), target, options.decimate);
  }
  return with_effort(effort, std::move(options), target, is_quick);
}

}  // namespace whittle
