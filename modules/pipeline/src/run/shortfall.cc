#include "run/shortfall.hh"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "run/per_mesh.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/text/text.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"

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

/// Those that are not given already, the most frequent reason first. \param mesh what they are to be tried on
std::vector<Lift> lifts(const IndexedMesh& mesh, const Decimation& result, const DecimateOptions& options,
                        bool keeps_meshes) {
  std::vector<Lift> all;
  const auto add = [&](bool helps, Refusal reason, const char* option, const auto& change) {
    if (!helps || result.result.refused_at_end[reason] == 0) return;
    all.push_back({reason, option, options});
    change(all.back().options);
  };
  if (result.result.refused_at_end[Refusal::link] > 0) add_lifts_of_input(mesh, options, keeps_meshes, all);
  add(options.topology == Topology::keep, Refusal::link, "--topology free",
      [](DecimateOptions& o) { o.topology = Topology::free; });
  const bool may_have_pairs = !keeps_meshes && !(options.pairs.threshold > 0);
  const double threshold = may_have_pairs ? automatic_threshold(result.mesh, options.threads) : 0;
  add(threshold > 0 && options.isotropy == 0 && options.valence_weight == 0, Refusal::link, "--threshold auto",
      [threshold](DecimateOptions& o) {
        o.pairs.threshold = threshold;
        o.cost = Cost::quadric;
        o.order = Order::automatic;
      });
  add(options.effective_max_normal_flip_deg() < 180, Refusal::flip, "--max-normal-flip 180",
      [](DecimateOptions& o) { o.max_normal_flip_deg = 180; });
  add(options.min_radius_ratio > 0, Refusal::shape, "--min-radius-ratio 0",
      [](DecimateOptions& o) { o.min_radius_ratio.reset(); });
  add(options.seams == Seams::keep, Refusal::feature, "--seams weighted",
      [](DecimateOptions& o) { o.seams = Seams::weighted; });
  add(options.feature_angle_deg.has_value(), Refusal::feature, "--feature-angle 180",
      [](DecimateOptions& o) { o.feature_angle_deg.reset(); });
  add(options.boundary == Boundary::locked, Refusal::locked, "--boundary weighted",
      [](DecimateOptions& o) { o.boundary = Boundary::weighted; });
  add(options.refuse_intersections, Refusal::intersection, "--self-intersections allow",
      [](DecimateOptions& o) { o.refuse_intersections = false; });
  std::stable_sort(all.begin(), all.end(), [&](const Lift& x, const Lift& y) {
    return result.result.refused_at_end[x.reason] > result.result.refused_at_end[y.reason];
  });
  return all;
}

DecimateResult try_on(const IndexedMesh& mesh, const DecimateTarget& target, const Lift& lift) {
  DecimateOptions options = lift.options;
  options.listener = nullptr;
  options.progress = nullptr;
  options.keep_quadrics = false;
  const IndexedMesh changed = lift.change_mesh ? lift.change_mesh(mesh) : mesh;
  if (options.locked.size() != changed.positions.size()) options.locked.clear();
  return decimate(changed, target, options).result;
}

Advice find_advice(const Plan& plan, const Decimation& result) {
  const IndexedMesh& input = plan.scene.read.mesh;
  const IndexedMesh& mesh = input.faces.size() <= most_faces_tried ? input : result.mesh;
  const std::vector<Lift> all = lifts(mesh, result, plan.options.decimate, keeps_meshes(plan.scene));
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
  return nearest == option || std::find(reaching.begin(), reaching.end(), option) != reaching.end();
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
    shortfall.meshes_above = meshes_above(plan.targets_per_mesh, *plan.scene.gltf, simplified.mesh);
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
