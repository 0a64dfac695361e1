#include "whittle/engine/simplify.hh"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "decimate/changes.hh"
#include "decimate/input_lines.hh"
#include "decimate/run.hh"
#include "simplify/nearer_result.hh"
#include "simplify/plain_trial.hh"
#include "simplify/polish_within.hh"
#include "simplify/simplify_sheets.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/polish/fit_attributes.hh"

namespace whittle {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Whether there is an option that memoryless quadrics don't take.
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

std::vector<double> pauses_by_effort(Effort effort, const DecimateOptions& options) {
  if (effort == Effort::fast || options.quadric.placement == Placement::endpoint) return {};
  return effort == Effort::best ? std::vector<double>{1.2, 1.1, 1.03} : std::vector<double>{1.1};
}

/// Vertices of the output that a locked vertex of the input became; empty if none is locked.
std::vector<std::uint8_t> locked_outputs(const std::vector<std::uint8_t>& locked, const Decimation& decimation) {
  std::vector<std::uint8_t> result;
  if (locked.empty()) return result;
  result.resize(decimation.mesh.positions.size());
  for (std::size_t v = 0; v < locked.size(); ++v) {
    const Index output = decimation.vertex_map[v];
    if (locked[v] != 0 && output != invalid_index) result[output] = 1;
  }
  return result;
}

/// What `decimate.progress` is told during polish.
ProgressCallback polish_progress(const DecimateOptions& decimate, const DecimateResult& result) {
  if (!decimate.progress) return {};
  return [&](const TaskProgress& progress) {
    return decimate.progress({result.n_vertices, result.n_faces, progress.fraction, Stage::polish});
  };
}

/// How much polish has to care for shape, where contraction does. By isotropy W, vertices are drawn to the middle of
/// their neighbours as much as contraction draws them to the middle of an edge (edge_length_term.hh). Valences say
/// nothing of places; but polish makes triangles less round, and a tenth of what W = 0.5 means makes up for that.
double shape_weight_of(const DecimateOptions& options) {
  constexpr double most = 1000;  // at W = 1 the error doesn't count
  constexpr double of_valences = 0.1;
  const double isotropy = options.isotropy;
  const double by_isotropy = isotropy < 1 ? std::min(most, isotropy / (1 - isotropy)) : most;
  return by_isotropy + of_valences * std::min(1.0, 2 * options.valence_weight);
}

/// What edges of the input have become.
std::vector<VertexPair> mapped(const std::vector<VertexPair>& edges, const std::vector<Index>& vertex_map) {
  std::vector<VertexPair> result;
  for (const auto& [a, b] : edges) {
    const auto [low, high] = std::minmax(vertex_map[a], vertex_map[b]);
    if (low != high && high != invalid_index) result.push_back({low, high});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void break_normals_of(const IndexedMesh& input, const SimplifyOptions& options, Decimation& decimation) {
  const DecimateOptions& decimate = options.decimate;
  break_normals(Frame::of_points(input.positions), decimate.normals, decimate.crease_angle_deg, decimation.mesh);
}

/// What polish looks up about the input.
struct PolishInput {
  PolishOriginal original;
  InputEdges edges;
  std::vector<Index> regions;  ///< of its faces, or empty
  double diagonal;             ///< of its bounding box
};

/// \param held a vertex of the decimation, 1 if it is to stay where it is; or empty
PolishResult polish_decimation(const PolishInput& input, const SimplifyOptions& options,
                               const std::vector<std::uint8_t>& held, Decimation& decimation) {
  const DecimateOptions& decimate = options.decimate;
  PolishOptions polish_options;
  polish_options.passes = *options.polish_passes;
  polish_options.fit = options.fit;
  polish_options.flips = *options.flips;
  polish_options.fit_borders = decimate.boundary != Boundary::locked;
  if (decimate.feature_angle_deg.value_or(180) < 180) polish_options.feature_angle_deg = *decimate.feature_angle_deg;
  if (decimate.min_radius_ratio) polish_options.min_radius_ratio = *decimate.min_radius_ratio;
  polish_options.shape_weight = shape_weight_of(decimate);
  polish_options.recompute_normals = false;  // in the end, after attributes are fitted
  polish_options.threads = decimate.threads;
  polish_options.progress = polish_progress(decimate, decimation.result);
  polish_options.locked = locked_outputs(decimate.locked, decimation);
  polish_options.locked.resize(std::max(polish_options.locked.size(), held.size()));
  for (std::size_t v = 0; v < held.size(); ++v) polish_options.locked[v] |= held[v];
  for (const Index f : input.regions.empty() ? std::vector<Index>{} : decimation.face_origins) {
    polish_options.regions.push_back(input.regions[f]);
  }
  polish_options.features = mapped(input.edges.features, decimation.vertex_map);
  polish_options.original_features = input.edges.features;
  if (std::isfinite(decimate.feature_tolerance)) {
    polish_options.feature_tolerance = decimate.feature_tolerance * input.diagonal;
  }
  const double seam_weight = decimate.attribute_weights.seam;
  if (!decimate.holds_seams() && seam_weight > 0) polish_options.seam_weight = seam_weight;
  if (decimate.holds_seams() || seam_weight > 0) {
    polish_options.seams = mapped(input.edges.seams, decimation.vertex_map);
    polish_options.original_seams = input.edges.seams;
  }
  return polish(input.original, decimation.vertex_map, decimation.mesh, polish_options);
}

/// Polishes decimations of one mesh.
class DecimationPolisher {
 public:
  explicit DecimationPolisher(const IndexedMesh& mesh) : mesh_(mesh) {}

  /// \param held a vertex of the decimation, 1 if it is to stay where it is; or empty
  PolishResult polish(const SimplifyOptions& options, Decimation& decimation,
                      const std::vector<std::uint8_t>& held = {}) {
    if (options.polish_passes == 0U) return {};
    const DecimateOptions& decimate = options.decimate;
    try {
      if (!input_) {
        PolishOriginal original(mesh_, decimate.threads, polish_progress(decimate, decimation.result));
        input_.emplace(PolishInput{std::move(original), input_edges_with_rims(mesh_, decimate),
                                   face_regions(mesh_, decimate.regions), diagonal_of(mesh_.positions)});
      }
      return polish_decimation(*input_, options, held, decimation);
    } catch (const Cancelled&) {
      PolishResult result;
      result.cancelled = true;
      return result;
    }
  }

 private:
  const IndexedMesh& mesh_;
  std::optional<PolishInput> input_;  ///< made when it is needed
};

/// The vertices of the input that those of the result stand for, ascending.
std::vector<Index> vertices_left(const Decimation& decimation) {
  std::vector<std::uint8_t> is_removed(decimation.vertex_map.size());
  for (const Contraction& contraction : decimation.steps.contractions) is_removed[contraction.removed] = 1;
  std::vector<Index> vertices;
  for (Index v = 0; v < is_removed.size(); ++v) {
    if (is_removed[v] == 0 && decimation.vertex_map[v] != invalid_index) vertices.push_back(v);
  }
  return vertices;
}

/// Runs `polish`, and notes what it changes.
template <class Polish>
PolishResult polish_and_note(Decimation& decimation, const Polish& polish) {
  if (decimation.steps.pass_ends.empty()) return polish();
  const std::vector<Vec3> positions = decimation.mesh.positions;
  const std::vector<Triangle> faces = decimation.mesh.faces;
  PolishResult result = polish();
  const std::vector<Index> vertices = vertices_left(decimation);
  PassEnd& end = decimation.steps.pass_ends.back();
  end.moved = moved_vertices(positions, decimation.mesh.positions, vertices);
  end.turned = turned_faces(faces, decimation.mesh.faces, vertices, decimation.face_origins);
  return result;
}

}  // namespace

PolishResult polish_decimation(const IndexedMesh& original, const SimplifyOptions& options, Decimation& decimation) {
  const PolishResult result = DecimationPolisher(original).polish(options, decimation);
  break_normals_of(original, options, decimation);
  return result;
}

SimplifyOptions with_effort(Effort effort, SimplifyOptions options) {
  const DecimateOptions& decimate = options.decimate;
  const bool is_cost_by_effort = !decimate.cost;
  options.decimate.cost = decimate.cost.value_or(cost_by_effort(effort, decimate));
  options.decimate.hold_rims = decimate.hold_rims.value_or(true);
  options.polish_passes = options.polish_passes.value_or(passes_by_effort(effort, options));
  options.flips = options.flips.value_or(effort == Effort::best);
  options.tries_plain_quadrics =
      options.tries_plain_quadrics.value_or(is_cost_by_effort && options.decimate.cost == Cost::memoryless &&
                                            effort != Effort::fast && !decimate.listener && decimate.pauses.at.empty());
  const bool has_pauses = options.polish_passes > 0U && decimate.pauses.at.empty();
  options.pauses = has_pauses ? options.pauses.value_or(pauses_by_effort(effort, decimate)) : std::vector<double>{};
  return options;
}

SimplifyOptions with_effort(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                            const DecimateTarget& target) {
  if (!options.decimate.cost && !needs_plain_quadrics(options.decimate)) {
    DecimateOptions memoryless = options.decimate;
    memoryless.cost = Cost::memoryless;
    if (goes_in_blocks(mesh, target, memoryless)) options.decimate.cost = Cost::memoryless;
  }
  return with_effort(effort, std::move(options));
}

namespace {

/// \pre all options are settled
Simplification simplify_as_settled(const IndexedMesh& mesh, const DecimateTarget& target, SimplifyOptions settled,
                                   DecimationPolisher& polisher) {
  const Clock::time_point start = Clock::now();
  double polish_seconds = 0;
  const auto polish_now = [&](Decimation& decimation, const SimplifyOptions& polish_options) {
    const Clock::time_point polish_start = Clock::now();
    PolishResult polish = polisher.polish(polish_options, decimation);
    polish_seconds += seconds_since(polish_start);
    return polish;
  };
  SimplifyOptions without_flips = settled;
  without_flips.flips = false;
  if (!settled.pauses->empty() && !target.error_limit()) {
    settled.decimate.pauses = {*settled.pauses,
                               [&](Decimation& paused) { return !polish_now(paused, without_flips).cancelled; }};
  }
  std::unique_ptr<ErrorBounds> bounds;
  Simplification result{run(mesh, target, settled.decimate, nullptr, {}, &bounds, settled.polish_passes == 0U),
                        *settled.decimate.cost,
                        {},
                        0,
                        0};
  if (result.result.stop != StopReason::cancelled && !bounds) {
    result.polish = polish_and_note(result, [&] { return polish_now(result, settled); });
  }
  if (result.result.proven_error) {
    const Clock::time_point polish_start = Clock::now();
    const auto polish_held = [&](Decimation& decimation, const auto& held) {
      return polisher.polish(without_flips, decimation, held);
    };
    result.polish = polish_and_note(result, [&] { return polish_within(*bounds, mesh, result, polish_held); });
    polish_seconds += seconds_since(polish_start);
  }
  result.polish_seconds = polish_seconds;
  result.decimate_seconds = seconds_since(start) - polish_seconds;
  return result;
}

/// Whether `other` is to be taken instead: it alone has reached the target, or it has and is nearer.
bool is_better(const IndexedMesh& input, const Simplification& other, const Simplification& result) {
  const bool is_reached = result.result.stop == StopReason::target;
  const bool is_other_reached = other.result.stop == StopReason::target;
  if (is_reached != is_other_reached) return is_other_reached;
  return is_nearer(input, other.mesh, result.mesh);
}

/// The attributes are fitted where positions are.
void fit_attributes_of(const IndexedMesh& input, const SimplifyOptions& settled, Simplification& result) {
  const bool is_cancelled = result.result.stop == StopReason::cancelled || result.polish.cancelled;
  if (is_cancelled || settled.polish_passes == 0U) return;
  const Clock::time_point start = Clock::now();
  const AttributeFitReport report =
      fit_attributes(input, wedge_map(input, result.vertex_map, result.face_origins), result.mesh,
                     {settled.decimate.normals == Normals::keep, settled.decimate.threads});
  result.n_folded_texture_faces = report.n_folded_faces;
  result.steps.fits_attributes = true;
  result.polish_seconds += seconds_since(start);
}

void finish_attributes_of(const IndexedMesh& input, const SimplifyOptions& settled, Simplification& result) {
  fit_attributes_of(input, settled, result);
  break_normals_of(input, settled, result);
}

/// With plain quadrics and without, where both are tried.
Simplification better_of_both(const IndexedMesh& mesh, const DecimateTarget& target, const SimplifyOptions& settled,
                              DecimationPolisher& polisher) {
  Simplification result = simplify_as_settled(mesh, target, settled, polisher);
  const bool is_cancelled = result.result.stop == StopReason::cancelled || result.polish.cancelled;
  if (is_cancelled || !*settled.tries_plain_quadrics || !is_worth_plain_quadrics(mesh, target)) return result;
  SimplifyOptions plain = settled;
  plain.decimate.cost = Cost::quadric;
  Simplification other = simplify_as_settled(mesh, target, plain, polisher);
  other.decimate_seconds += result.decimate_seconds;
  other.polish_seconds += result.polish_seconds;
  const Clock::time_point compare_start = Clock::now();
  Simplification& better = is_better(mesh, other, result) ? other : result;
  better.decimate_seconds = other.decimate_seconds;
  better.polish_seconds = other.polish_seconds + seconds_since(compare_start);
  return std::move(better);
}

}  // namespace

Simplification simplify(const IndexedMesh& mesh, const DecimateTarget& target, Effort effort,
                        const SimplifyOptions& options) {
  if (const TwoSidedSheets sheets(mesh); sheets.any()) return simplify_sheets(sheets, target, effort, options);
  const SimplifyOptions settled = with_effort(effort, options, mesh, target);
  DecimationPolisher polisher(mesh);
  Simplification result = better_of_both(mesh, target, settled, polisher);
  finish_attributes_of(mesh, settled, result);
  return result;
}

namespace {

std::uint64_t count_of(const DecimateTarget& target) {
  return target.n_faces().value_or(target.n_vertices().value_or(0));
}

/// \throw std::invalid_argument
void check_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets, const SimplifyOptions& options) {
  const auto require = [](bool is_so, const char* what) {
    if (!is_so) throw std::invalid_argument(std::string("simplify_to_levels: ") + what);
  };
  require(!targets.empty(), "there is no target");
  require(options.decimate.pauses.at.empty() && !options.pauses, "pauses don't go with levels");
  const bool has_faces = targets.front().n_faces().has_value();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const DecimateTarget& target = targets[i];
    require(target.n_faces().has_value() == has_faces && target.n_vertices().has_value() != has_faces,
            "a target is no count, or counts are not all of one kind");
    require(!target.cost_limit() && !target.error_limit(), "a target limits the cost or the error");
    require(i == 0 || count_of(target) < count_of(targets[i - 1]), "targets are not in descending order");
  }
  require(count_of(targets.front()) < (has_faces ? mesh.faces.size() : mesh.positions.size()),
          "the mesh has reached a target");
}

/// Multiples of the last target's count that come to the counts of the others, rounded up.
std::vector<double> pauses_at(const std::vector<DecimateTarget>& targets) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
    at.push_back((static_cast<double>(count_of(targets[i])) - 0.5) / static_cast<double>(count_of(targets.back())));
  }
  return at;
}

}  // namespace

std::vector<Simplification> simplify_to_levels(const IndexedMesh& mesh, const std::vector<DecimateTarget>& targets,
                                               Effort effort, const SimplifyOptions& options) {
  check_levels(mesh, targets, options);
  if (const TwoSidedSheets sheets(mesh); sheets.any())
    return simplify_sheets_to_levels(sheets, targets, effort, options);
  SimplifyOptions settled = with_effort(effort, options, mesh, targets.front());
  settled.pauses->clear();
  SimplifyOptions without_flips = settled;
  without_flips.flips = false;
  DecimationPolisher polisher(mesh);
  const Frame frame = Frame::of_points(mesh.positions);
  std::vector<Simplification> levels;
  double polish_seconds = 0;
  const auto add_level = [&](Decimation& paused) {
    const Clock::time_point start = Clock::now();
    const PolishResult polish = polisher.polish(without_flips, paused);
    polish_seconds += seconds_since(start);
    levels.push_back({paused, *settled.decimate.cost, polish, 0, 0, 0});
    Decimation& level = levels.back();
    carry_attributes(mesh, frame, settled.decimate.normals, level.vertex_map, level.face_origins, level.mesh,
                     settled.decimate.threads, settled.polish_passes == 0U);
    finish_attributes_of(mesh, settled, levels.back());
    return !polish.cancelled;
  };
  settled.decimate.pauses = {pauses_at(targets), add_level};
  levels.push_back(simplify_as_settled(mesh, targets.back(), settled, polisher));
  finish_attributes_of(mesh, settled, levels.back());
  levels.back().decimate_seconds -= polish_seconds;
  levels.back().polish_seconds += polish_seconds;
  return levels;
}

}  // namespace whittle
