#include "commands/advice.hh"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "whittle/engine/automatic_threshold.hh"

namespace whittle::app {
namespace {

/// Larger meshes are not decimated on trial: the advice is to take little time.
constexpr std::size_t most_faces_tried = 200'000;

struct Reason {
  std::uint64_t Rejections::*count;
  const char* text;
};
constexpr Reason reasons[] = {{&Rejections::link, "by topology"},
                              {&Rejections::flip, "by turning a face"},
                              {&Rejections::shape, "by shape"},
                              {&Rejections::feature, "by features"},
                              {&Rejections::locked, "locked"}};

/// An option that lifts a reason.
struct Lift {
  std::uint64_t Rejections::*reason;
  std::string option;
  DecimateOptions options;  ///< those of the run, with it
};

/// Those that are not given already, the most frequent reason first.
std::vector<Lift> lifts(const Decimation& result, const DecimateOptions& options) {
  std::vector<Lift> all;
  const auto add = [&](bool helps, std::uint64_t Rejections::*reason, const char* option, const auto& change) {
    if (!helps || result.result.refused_at_end.*reason == 0) return;
    all.push_back({reason, option, options});
    change(all.back().options);
  };
  add(options.topology == Topology::keep, &Rejections::link, "--topology free",
      [](DecimateOptions& o) { o.topology = Topology::free; });
  const bool has_pairs = options.pairs.threshold > 0;
  const double threshold = has_pairs ? 0 : automatic_threshold(result.mesh, options.threads);
  add(threshold > 0 && options.isotropy == 0 && options.valence_weight == 0, &Rejections::link, "--threshold auto",
      [threshold](DecimateOptions& o) {
        o.pairs.threshold = threshold;
        o.cost = Cost::quadric;
        o.order = Order::automatic;
      });
  add(options.effective_max_normal_flip_deg() < 180, &Rejections::flip, "--max-normal-flip 180",
      [](DecimateOptions& o) { o.max_normal_flip_deg = 180; });
  add(options.min_radius_ratio > 0, &Rejections::shape, "--min-radius-ratio 0",
      [](DecimateOptions& o) { o.min_radius_ratio.reset(); });
  add(options.feature_angle_deg.has_value(), &Rejections::feature, "--feature-angle 180",
      [](DecimateOptions& o) { o.feature_angle_deg.reset(); });
  add(options.boundary == Boundary::locked, &Rejections::locked, "--boundary weighted",
      [](DecimateOptions& o) { o.boundary = Boundary::weighted; });
  std::stable_sort(all.begin(), all.end(), [&](const Lift& x, const Lift& y) {
    return result.result.refused_at_end.*x.reason > result.result.refused_at_end.*y.reason;
  });
  return all;
}

DecimateResult try_on(const IndexedMesh& mesh, const DecimateTarget& target, DecimateOptions options) {
  options.listener = nullptr;
  options.progress = nullptr;
  options.keep_quadrics = false;
  return decimate(mesh, target, options).result;
}

/// The best of several trials so far.
struct Best {
  std::string option;
  std::uint64_t n_faces;
};

}  // namespace

std::string reasons_at_end(const Rejections& refused) {
  std::vector<Reason> sorted(std::begin(reasons), std::end(reasons));
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Reason& x, const Reason& y) { return refused.*x.count > refused.*y.count; });
  std::string text;
  for (const auto& [count, words] : sorted) {
    if (refused.*count == 0) break;
    text += (text.empty() ? "" : ", ") + std::to_string(refused.*count) + ' ' + words;
  }
  return text;
}

std::string advice(const IndexedMesh& input, const Decimation& result, const DecimateTarget& target,
                   const DecimateOptions& options) {
  const std::vector<Lift> all = lifts(result, options);
  if (all.empty()) return "no option lifts that";
  if (result.mesh.faces.size() > most_faces_tried) return "'" + all.front().option + "' may get further";
  const IndexedMesh& mesh = input.faces.size() <= most_faces_tried ? input : result.mesh;
  std::string reaching;
  std::optional<Best> best;
  for (const Lift& lift : all) {
    const DecimateResult reached = try_on(mesh, target, lift.options);
    if (reached.stop != StopReason::exhausted) reaching += (reaching.empty() ? "'" : " or '") + lift.option + "'";
    if (reached.n_faces < (best ? best->n_faces : result.mesh.faces.size())) best = {lift.option, reached.n_faces};
  }
  if (!reaching.empty()) return reaching + " reaches it";
  if (!best) return "no single option gets further";
  return "'" + best->option + "' gets to " + std::to_string(best->n_faces) + " faces";
}

}  // namespace whittle::app
