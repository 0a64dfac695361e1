#include "commands/simplify/advice.hh"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "terminal/table.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/io/border_gaps.hh"

namespace whittle::app {
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

/// The best of several trials so far.
struct Best {
  std::string option;
  std::uint64_t n_faces;
};

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

std::string advice(const IndexedMesh& input, const Decimation& result, const DecimateTarget& target,
                   const DecimateOptions& options, bool keeps_meshes) {
  const IndexedMesh& mesh = input.faces.size() <= most_faces_tried ? input : result.mesh;
  const std::vector<Lift> all = lifts(mesh, result, options, keeps_meshes);
  if (all.empty()) return "no option lifts that";
  if (mesh.faces.size() > most_faces_tried) return "'" + all.front().option + "' may get further";
  std::string reaching;
  std::optional<Best> best;
  for (const Lift& lift : all) {
    const DecimateResult reached = try_on(mesh, target, lift);
    if (reached.stop != StopReason::exhausted) reaching += (reaching.empty() ? "'" : " or '") + lift.option + "'";
    if (reached.n_faces < (best ? best->n_faces : result.mesh.faces.size())) best = {lift.option, reached.n_faces};
  }
  if (!reaching.empty()) return reaching + " reaches it";
  if (!best) return "no single option gets further";
  return "'" + best->option + "' gets to " + faces_text(best->n_faces);
}

}  // namespace whittle::app
