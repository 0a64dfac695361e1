#include "run/shortfall.hh"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "plan/simplify_options.hh"
#include "run/per_mesh.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/text/text.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/pipeline/option.hh"

namespace whittle {
namespace {

/// Larger meshes are not decimated on trial: the advice is to take little time.
constexpr std::size_t most_faces_tried = 200'000;

/// An option that lifts a reason.
struct Lift {
  Refusal reason;
  std::string option;
  DecimateOptions options;                                ///< those of the run, with it
  std::function<IndexedMesh(IndexedMesh)> change_mesh{};  ///< what it does to the input, if anything
};

/// Options that change the input so that fewer contractions change its topology.
void add_lifts_of_input(const IndexedMesh& mesh, const DecimateOptions& options, bool keeps_meshes,
                        std::vector<Lift>& all) {
  constexpr double small = 0.01;        // of the diagonal
  constexpr double most_dropped = 0.1;  // of the faces
  if (const double tolerance = keeps_meshes ? 0 : io::find_border_gaps(mesh).tolerance(); tolerance > 0) {
    all.push_back({Refusal::link, "--weld auto", options, [tolerance](IndexedMesh changed) {
                     io::weld_gaps(changed, tolerance);
                     return changed;
                   }});
  }
  const auto prune = [size = small * diagonal_of(mesh.positions)](IndexedMesh changed) {
    return without_small_parts(std::move(changed), size);
  };
  const std::size_t n_dropped = prune(mesh).n_dropped_faces;
  if (n_dropped > 0 && static_cast<double>(n_dropped) < most_dropped * static_cast<double>(mesh.faces.size())) {
    all.push_back({Refusal::link, "--prune 1%", options,
                   [prune](IndexedMesh changed) { return prune(std::move(changed)).mesh; }});
  }
}

/// Options whose rows lift a reason, and that are not given so already.
void add_lifts_by_rows(const Plan& plan, std::vector<Lift>& all) {
  Request given = plan.request;
  given.simplify = plan.options;
  Request request = given;
  for (const OptionRow& row : option_rows(request)) {
    if (!row.lift) continue;
    const std::string now = to_string(row.access.get());
    row.access.set(row.lift->value);
    const bool is_changed = to_string(row.access.get()) != now;
    if (is_changed && (row.lift->cause.empty() || row.lift->cause == now)) {
      all.push_back({row.lift->reason, long_name(row) + ' ' + row.lift->value, simplify_options(request).decimate});
    }
    request = given;
  }
}

/// Threshold pairs join parts whose last faces may not vanish. \param mesh whose parts may lie near one another
void add_lift_by_pairs(const Plan& plan, const IndexedMesh& mesh, std::vector<Lift>& all) {
  DecimateOptions options = plan.options.decimate;
  const bool may_have_pairs =
      !keeps_meshes(plan.scene) && plan.threshold() == 0 && options.isotropy == 0 && options.valence_weight == 0;
  if (!may_have_pairs) return;
  const double threshold = automatic_threshold(mesh, options.threads);
  if (threshold == 0) return;
  options.pairs.threshold = threshold;
  options.cost = Cost::quadric;
  options.order = Order::automatic;
  all.push_back({Refusal::link, "--threshold auto", options});
}

/// Options that lift reasons for which pairs are refused at the end, the most frequent reason first.
/// \param mesh what they are to be tried on
std::vector<Lift> find_lifts(const Plan& plan, const IndexedMesh& mesh, const Decimation& result) {
  const RefusalCounts& refused = result.result.refused_at_end;
  std::vector<Lift> all;
  if (refused[Refusal::link] > 0) add_lifts_of_input(mesh, plan.options.decimate, keeps_meshes(plan.scene), all);
  add_lifts_by_rows(plan, all);
  if (refused[Refusal::link] > 0) add_lift_by_pairs(plan, result.mesh, all);
  std::erase_if(all, [&](const Lift& lift) { return refused[lift.reason] == 0; });
  std::stable_sort(all.begin(), all.end(),
                   [&](const Lift& x, const Lift& y) { return refused[x.reason] > refused[y.reason]; });
  return all;
}

/// \param mesh the input of the run, or another
DecimateResult try_on(const IndexedMesh& mesh, const DecimateTarget& target, const Lift& lift) {
  DecimateOptions options = lift.options;
  options.listener = nullptr;
  options.progress = nullptr;
  options.keep_quadrics = false;
  const IndexedMesh changed = lift.change_mesh ? lift.change_mesh(mesh) : mesh;
  if (options.locked.size() != changed.positions.size()) options.locked.clear();
  if (options.tolerances.size() != changed.positions.size()) options.tolerances.clear();
  return decimate(changed, target, options).result;
}

Advice find_advice(const Plan& plan, const Decimation& result) {
  const IndexedMesh& input = plan.scene.read.mesh;
  const IndexedMesh& mesh = input.faces.size() <= most_faces_tried ? input : result.mesh;
  const std::vector<Lift> all = find_lifts(plan, mesh, result);
  Advice advice;
  advice.has_options = !all.empty();
  if (advice.has_options && mesh.faces.size() > most_faces_tried) advice.nearest = all.front().option;
  if (mesh.faces.size() > most_faces_tried) return advice;
  std::uint64_t fewest = result.mesh.faces.size();
  for (const Lift& lift : all) {
    const DecimateResult reached = try_on(mesh, plan.target, lift);
    if (reached.stop != StopReason::exhausted) advice.reaching.push_back(lift.option);
    if (reached.n_faces >= fewest) continue;
    fewest = reached.n_faces;
    advice.nearest = lift.option;
    advice.n_faces = reached.n_faces;
  }
  return advice;
}

/// What stood in the way of the target, and what lifts it.
std::string obstacle_text(const Plan& plan, const Outcome& outcome) {
  const Shortfall& shortfall = *outcome.shortfall;
  if (!shortfall.ended_by.empty()) return '\'' + std::string(shortfall.ended_by) + "' ended it";
  const DecimateResult& result = outcome.simplified.result;
  const std::string refused = refusals_text(plan, result.refusals) + "; ";
  if (plan.request.decimater) return refused + "'--engine flat' may get further";
  const std::string left = reasons_at_end(result.refused_at_end);
  if (left.empty()) return refused + "nothing is left that may be contracted";
  return refused + "the pairs left: " + left + (shortfall.advice ? "; " + to_string(*shortfall.advice) : "");
}

}  // namespace

std::string reasons_at_end(const RefusalCounts& refused) {
  auto sorted = all_refusals;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const RefusalRow& x, const RefusalRow& y) { return refused[x.refusal] > refused[y.refusal]; });
  std::string text;
  for (const RefusalRow& row : sorted) {
    if (refused[row.refusal] == 0) break;
    text += (text.empty() ? "" : ", ") + std::to_string(refused[row.refusal]) + ' ' + std::string(row.words);
  }
  return text;
}

bool Advice::names(std::string_view option) const {
  if (reaching.empty()) return nearest == option;
  return std::find(reaching.begin(), reaching.end(), option) != reaching.end();
}

std::string to_string(const Advice& advice) {
  if (!advice.has_options) return "no option lifts that";
  std::string reaching;
  for (const std::string& option : advice.reaching) reaching += (reaching.empty() ? "'" : " or '") + option + "'";
  if (!reaching.empty()) return reaching + " reaches it";
  if (advice.nearest.empty()) return "no single option gets further";
  return "'" + advice.nearest + (advice.n_faces ? "' gets to " + faces_text(*advice.n_faces) : "' may get further");
}

std::string refusals_text(const Plan& plan, const RefusalCounts& refused) {
  if (plan.request.decimater) return "OpenMesh doesn't say what it refused";
  std::string text;
  for (const RefusalRow& row : all_refusals) {
    if (refused[row.refusal] == 0 && !row.is_always_told) continue;
    text += (text.empty() ? "refused: " : ", ") + std::to_string(refused[row.refusal]) + ' ' + std::string(row.words);
  }
  return text;
}

Shortfall find_shortfall(const Plan& plan, const Simplification& simplified) {
  Shortfall shortfall;
  const DecimateResult& result = simplified.result;
  shortfall.ended_by = option_that_ended(result.stop);
  if (plan.request.is_per_mesh) {
    shortfall.meshes_above = meshes_above(plan.targets_per_mesh, *plan.scene.document, simplified.mesh);
    return shortfall;
  }
  const bool may_go_on = shortfall.ended_by.empty() && !plan.request.decimater && result.refused_at_end.total() > 0;
  if (may_go_on) shortfall.advice = find_advice(plan, simplified);
  return shortfall;
}

std::string shortfall_text(const Plan& plan, const Outcome& outcome) {
  const DecimateResult& result = outcome.simplified.result;
  const std::vector<std::string>& above = outcome.shortfall->meshes_above;
  std::string where;
  if (!above.empty()) {
    where = " by " + above.front() + (above.size() > 1 ? " and " + std::to_string(above.size() - 1) + " more" : "");
  }
  return plan.scene.name + ": target not met" + where + ": " + to_string(counts_of(plan.target)) + " asked, " +
         faces_text(result.n_faces) + " and " + vertices_text(result.n_vertices) + " reached; " +
         obstacle_text(plan, outcome);
}

}  // namespace whittle
