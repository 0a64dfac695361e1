#include "blocks/contract_in_blocks.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cost/attributes/scaled_attributes.hh"
#include "cost/fold_edges.hh"
#include "cost/seam_planes.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

constexpr double highest_share = 0.7;  ///< of the faces to be left

MeanFaceArea mean_face_area(const IndexedMesh& mesh, const Frame& frame, unsigned threads) {
  const std::size_t n = mesh.faces.size();
  std::vector<double> areas((n + range_length - 1) / range_length);  // by range
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    double& sum = areas[begin / range_length];
    for (std::size_t f = begin; f < end; ++f) sum += area_of(frame.to_frame(corners_of(mesh.positions, mesh.faces[f])));
  });
  double area = 0;
  for (const double part : areas) area += part;
  return {area, n, n};
}

/// Whether the mesh is so large beside its edges that costs are rounding errors: most of those about 1000 faces are
/// shorter than a 10⁵th of its diagonal.
bool is_far_flung(const IndexedMesh& mesh) {
  constexpr double most = 1e5;
  const std::size_t step = std::max<std::size_t>(1, mesh.faces.size() / 1000);
  std::vector<double> lengths;
  for (std::size_t f = 0; f < mesh.faces.size(); f += step) {
    const Vec3 edge = mesh.positions[mesh.faces[f][1]] - mesh.positions[mesh.faces[f][0]];
    lengths.push_back(edge.stableNorm());
  }
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  return !(diagonal_of(mesh.positions) <= most * *median);
}

/// How many times as many vertices as the target asks for the blocks leave. The more is contracted, the denser is what
/// they leave at their borders. \param share of the input that the target asks for
double surplus_of_blocks(const BlockPlan& plan, bool ends_in_rounds, double share) {
  if (!ends_in_rounds) return plan.surplus;
  const double fewer = std::clamp((share - 0.125) / 0.175, 0.0, 1.0);
  return std::lerp(plan.surplus_before_rounds, plan.least_surplus_before_rounds, fewer);
}

/// Blocks contract what costs least in each, or what moves the surface little. \return why they couldn't, or empty
std::string_view run_levels(const LevelContext& context, const BlockPlan& plan, double n_vertices_left,
                            WorkingSurface& surface, StageReport& report) {
  LevelPlan level{plan.faces_per_block, 0.5, Role::alone};
  LevelGoal goal;
  goal.surplus = surplus_of_blocks(plan, goes_to_target(context.stage.options), context.target_share);
  goal.most_nonmanifold = plan.highest_nonmanifold_share * n_vertices_left;
  if (context.stage.limits.displacement) {
    goal.cost = std::numeric_limits<double>::infinity();
    goal.most_nonmanifold = std::numeric_limits<double>::infinity();
  }
  const std::optional<double> cost = run_level(context, level, goal, surface, report);
  if (!cost) return "much of it isn't manifold";
  const bool is_once = context.stage.limits.displacement || surface.faces.size() < plan.fewest_faces_again;
  if (is_once || context.progress.is_cancelled()) return {};
  level.first_share = 0.3;
  run_level(context, level, {.cost = cost}, surface, report);
  return {};
}

/// Blocks contract what one queue for all would contract, too. Small blocks that don't keep the order find the cost.
/// \return as `run_levels`
std::string_view run_exact_levels(const LevelContext& context, const BlockPlan& plan, WorkingSurface& surface,
                                  StageReport& report) {
  const LevelPlan trial{plan.faces_per_block / 2, 0.5, Role::alone, true};
  LevelGoal goal;
  goal.cost = find_cost(context, trial, plan.surplus_in_exact_order, surface);
  goal.least_done = plan.least_done_in_exact_order;
  LevelPlan level{plan.faces_per_block_in_exact_order[0], 0.5, Role::in_exact_order};
  if (!run_level(context, level, goal, surface, report)) return "pairs wait for each other all over the mesh";
  const bool is_enough = surface.faces.size() < plan.fewest_faces_again_in_exact_order;
  if (is_enough || context.progress.is_cancelled()) return {};
  level.faces_per_block = plan.faces_per_block_in_exact_order[1];
  level.first_share = 0.3;
  goal.least_done = 0;
  run_level(context, level, goal, surface, report);
  return {};
}

}  // namespace

std::string_view why_not_in_blocks(const IndexedMesh& mesh, const DecimateTarget& target,
                                   const DecimateOptions& options, const DecimationHost* host, const BlockPlan& plan,
                                   bool is_told) {
  const bool is_exact = is_exact_in_blocks(options);
  if (mesh.faces.size() < (is_exact ? plan.fewest_faces_in_exact_order : plan.fewest_faces)) return "the mesh is small";
  if (target.error_limit()) return "the error is limited";
  if (!target.n_faces() && !target.n_vertices()) return "there is no count to reach";
  if (target.cost_limit()) return "the cost is limited";
  if (target.share_of(mesh.faces.size(), mesh.positions.size()) > highest_share) return "the target is near";
  if (host != nullptr) return "a host takes part";
  if (is_exact) {
    if (options.isotropy > 0) return "the cost has a term for edge lengths";
    if (options.quadric.regularization < QuadricOptions{}.regularization) return "rounding may decide the order";
    if (is_told) return "contractions are told in exact order";
    if (n_threads(options.threads) == 1) return "one thread works";
  } else {
    if (!cost_traits(options.effective_cost()).goes_in_blocks) return "the cost may fall, or is not of quadrics";
    if (options.effective_order() != Order::approximate) return "the order is exact";
    if (is_told && mesh.faces.size() < plan.fewest_faces_in_detail) return "contractions are told in order";
  }
  if (is_exact && options.quadric.placement != Placement::optimal) return "vertices stay where they are";
  if (is_exact && options.valence_weight > 0) return "the cost has a term for valences";
  if (options.pairs.threshold > 0) return "threshold pairs join what lies apart";
  if (options.topology == Topology::free) return "the topology may change";
  if (options.feature_angle_deg.value_or(180) < 180 || !options.feature_edges.empty()) return "feature lines are kept";
  const bool seams_are_kept = is_exact || options.holds_seams();
  if (seams_are_kept && (!mesh.wedges.empty() || !face_regions(mesh, options.regions).empty())) return "seams are kept";
  if (is_exact && looks_at_attributes(options, mesh)) return "attributes count";
  if (options.refuse_intersections) return "intersections are refused";
  if (is_exact && is_far_flung(mesh)) return "rounding may decide the order";
  if (is_exact && !held_folds(mesh, Frame::of_points(mesh.positions), options).empty()) return "folds are held";
  return {};
}

bool goes_to_target(const DecimateOptions& options) {
  return options.effective_cost() == Cost::memoryless && !options.keep_quadrics;
}

double n_vertices_left(const DecimateTarget& target, const IndexedMesh& mesh) {
  const auto n = static_cast<double>(mesh.positions.size());
  return std::max(1.0, target.share_of(mesh.faces.size(), mesh.positions.size()) * n);
}

bool is_nearly_manifold(const SurfaceCounts& before, const DecimateTarget& target, const IndexedMesh& mesh) {
  constexpr double most = 0.01;  // of the vertices to be left
  const std::uint64_t n = before.nonmanifold_edges + before.nonmanifold_vertices;
  return static_cast<double>(n) <= most * n_vertices_left(target, mesh);
}

StageReport contract_in_blocks(WorkingSurface& surface, const IndexedMesh& mesh, const DecimateTarget& target,
                               const BlockPlan& plan, const StageContext& context) {
  const DecimateOptions& options = context.options;
  const std::size_t n_vertices = surface.positions.size();
  const std::size_t n_faces = surface.faces.size();
  SharedProgress progress(options, n_vertices, n_faces, std::min(0.999, target.share_of(n_faces, n_vertices)));
  bool ends_in_rounds = goes_to_target(options) && !context.limits.displacement;
  const double fewest_left = ends_in_rounds ? plan.fewest_faces_left_before_rounds : plan.fewest_faces_left;
  const double share = std::max(fewest_left / static_cast<double>(plan.faces_per_block),
                                target.share_of(mesh.faces.size(), mesh.positions.size()));
  const LevelContext level_context{context, mesh, share, progress};
  WorkingSurface left = surface;
  StageReport report;
  if (context.keeps_steps) reserve_large(report.steps.contractions, mesh.positions.size());
  std::string_view why_not;
  if (surface.is_input()) {
    left.cost_state.face_area = mean_face_area(mesh, context.frame, options.threads);
    left.cost_state.seams = seam_planes(mesh, context.frame, seam_edges(mesh, face_regions(mesh, options.regions)),
                                        held_folds(mesh, context.frame, options), options);
    why_not = is_exact_in_blocks(options)
                  ? run_exact_levels(level_context, plan, left, report)
                  : run_levels(level_context, plan, n_vertices_left(target, mesh), left, report);
    ends_in_rounds = ends_in_rounds && is_nearly_manifold(report.result.before, target, mesh);
  }
  if (ends_in_rounds && why_not.empty() && !progress.is_cancelled())
    contract_in_rounds(level_context, target, left, report);
  if (why_not.empty()) surface = std::move(left);
  report.result.why_in_one_pass = why_not;
  if (progress.is_cancelled()) report.result.stop = StopReason::cancelled;
  report.progress = progress.now().fraction;
  return report;
}

}  // namespace whittle
