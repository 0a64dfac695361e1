#include "polisher.hh"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "fit/surface_fit.hh"
#include "flips/edge_flips.hh"
#include "guard/drifted_lines.hh"
#include "guard/drifted_vertices.hh"
#include "guard/new_intersections.hh"
#include "original/backward_offsets.hh"
#include "original/closest_point_finder.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/geometry/radius_ratio.hh"

namespace whittle::polishing {
namespace {

/// The step of a pass.
struct Step {
  /// As a face moves, its closest points move along, so the step that fits the present ones best is too short. Where
  /// the longer step goes too far, the shorter one is tried.
  double relaxation;
  /// Factor on the weight of shape. Where a pass makes triangles less round, larger factors are tried: points pull much
  /// harder on a rough surface than on a smooth one.
  double shape_factor = 1;
};
constexpr std::array steps{Step{1.5}, Step{1.0}};
constexpr std::array shape_steps{Step{1.5}, Step{1.5, 10}, Step{1.5, 100}, Step{1.0, 100}};

/// Distances, in root mean square distances.
struct Limits {
  double near;  ///< up to here a vertex is near the original, and not held back: the pull would be below a thousandth
  double most;  ///< few vertices should be so far off; the pull on them grows steeply
  /// Few of the original's points should be so far off; infinite: Fair's weights alone.
  double far_forward;
};

/// On a smooth surface the best vertices are 2.6 root mean square distances off: as far as the middles of their faces,
/// on the other side.
Limits limits_of(Fit fit) {
  constexpr double none = std::numeric_limits<double>::infinity();
  switch (fit) {
    case Fit::mean:
      return {5, 8, none};
    case Fit::max:
      return {2.7, 4.3, 4.3};
    case Fit::balanced:
      break;
  }
  return {3.5, 5.5, none};
}

/// Share of the original's faces above which one point per face is too few to fit the simplified mesh.
constexpr double dense = 0.3;

/// Distances of this root mean square are rounding errors: the mesh is as good as the original. A fraction of the size
/// of both meshes, which is about 1 in their frame.
constexpr double rounding = 1e-14;

/// A shape weight of 1, as a share of the weight of the points around a vertex. The edge-length term of contractions
/// draws vertices to their middle by as much (edge_length_term.hh).
constexpr double shape_unit = 1e-3;

/// Time for the preparations, as a share of a pass.
constexpr double preparation = 0.25;

/// The lines of a mesh. An edge counts once; an edge that is feature and seam is a feature.
MeshLines lines_of(std::span<const VertexPair> borders, std::span<const VertexPair> features,
                   std::span<const VertexPair> seams, std::size_t n_vertices) {
  const auto ascending = [](std::span<const VertexPair> edges) {
    std::vector<VertexPair> sorted;
    for (const auto& [a, b] : edges) sorted.push_back({std::min(a, b), std::max(a, b)});
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
  };
  const std::vector<VertexPair> all_features = ascending(features);
  const std::vector<VertexPair> all_seams = ascending(seams);
  std::vector<VertexPair> only_seams;
  std::set_difference(all_seams.begin(), all_seams.end(), all_features.begin(), all_features.end(),
                      std::back_inserter(only_seams));
  return MeshLines(borders, all_features, only_seams, n_vertices);
}

/// The border, and features and seams with two faces.
MeshLines lines_of(const IndexedMesh& mesh, const FaceNeighbors& neighbors, const PolishOptions& options,
                   const detail::Workers& workers) {
  workers.update(0);
  const auto inner = [&neighbors](const std::vector<VertexPair>& edges) {
    std::vector<VertexPair> kept;
    for (const auto& [a, b] : edges) {
      if (neighbors.inner_side(a, b).face != invalid_index) kept.push_back({a, b});
    }
    return kept;
  };
  return lines_of(detail::border_edges(mesh.faces, mesh.positions.size()), inner(options.features),
                  inner(options.seams), mesh.positions.size());
}

/// Whether a vertex must stay because lines end or meet there. With `seams_hold`, this includes vertices where seams
/// meet, or lead to a border or feature.
bool is_end_of_lines(const MeshLines& lines, Index v, bool seams_hold) {
  const std::span<const Index> edges = lines.at(v);
  const auto n_seams = static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](Index e) { return lines.edges()[e].kind == LineKind::seam; }));
  const std::size_t n_lines = seams_hold || edges.size() == 1 ? edges.size() : edges.size() - n_seams;
  return n_lines != 0 && n_lines != 2;
}

/// Fixed vertices: locked, non-manifold, or at the end or junction of lines.
std::vector<std::uint8_t> fixed_vertices(const FaceNeighbors& neighbors, const MeshLines& lines, std::size_t n_vertices,
                                         const PolishOptions& options, const detail::Workers& workers) {
  std::vector<std::uint8_t> is_fixed(n_vertices);
  for_each_range(n_vertices, workers, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Fan fan = neighbors.fan(v);
      is_fixed[v] = (!options.locked.empty() && options.locked[v] != 0) || fan == Fan::none ||
                    (fan == Fan::open && !options.fit_borders) ||
                    (!lines.empty() && is_end_of_lines(lines, v, !options.seam_weight));
    }
  });
  return is_fixed;
}

std::vector<Vec3> in_frame(std::span<const Vec3> positions, const Frame& frame) {
  std::vector<Vec3> result;
  result.reserve(positions.size());
  for (const Vec3& p : positions) result.push_back(frame.to_frame(p));
  return result;
}

/// Mean radius ratio.
double roundness(const Surface& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces) sum += radius_ratio(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  return sum / static_cast<double>(mesh.faces.size());
}

std::size_t points_per_face(const OriginalSurface& original, const IndexedMesh& mesh) {
  return static_cast<double>(mesh.faces.size()) > dense * static_cast<double>(original.faces().size()) ? 4 : 1;
}

}  // namespace

double run_fraction(double n_passes, const PolishOptions& options) {
  return (preparation + n_passes) / (preparation + options.passes);
}

Connectivity::Connectivity(std::vector<Triangle> the_faces, std::size_t n_vertices, const PolishOptions& options,
                           const detail::Workers& workers)
    : faces(std::move(the_faces)),
      corners(corners_by_vertex(faces, n_vertices)),
      neighbors(faces, corners, workers),
      limits(neighbors, options.features, options.feature_angle_deg, options.min_radius_ratio.value_or(0)) {}

Polisher::Polisher(const OriginalSurface& original, std::span<const Index> vertex_map, const IndexedMesh& mesh,
                   const PolishOptions& options, detail::ProgressMeter& meter)
    : options_(options),
      meter_(meter),
      workers_(options.threads, &meter),
      original_(original),
      positions_(in_frame(mesh.positions, original.frame())),
      origins_(original, vertex_map, mesh.positions.size(), points_per_face(original, mesh), workers_),
      mesh_(std::make_unique<Connectivity>(mesh.faces, mesh.positions.size(), options, workers_)),
      lines_(lines_of(mesh, mesh_->neighbors, options, workers_)),
      line_samples_(original_lines(), original_.positions(), vertex_map),
      is_fixed_(fixed_vertices(mesh_->neighbors, lines_, mesh.positions.size(), options, workers_)),
      can_flip_(options.flips) {
  distances_ = two_sided_distances(origins_, mesh_->at(positions_), workers_);
}

bool Polisher::pass() {
  ++n_passes_;
  begun_until_ = 0;
  const double unit = root_mean_square(distances_);
  if (!(unit > rounding)) return false;
  std::unique_ptr<Connectivity> flipped = flip();
  const Connectivity& mesh = flipped ? *flipped : *mesh_;
  const Surface now = mesh.at(positions_);
  const Limits limits = limits_of(options_.fit);
  const FitWeights weights(unit, limits.far_forward);
  start("fitting", 0.5);
  SurfaceFit fit(now, mesh.neighbors, mesh.limits, lines_, is_fixed_, workers_);
  line_samples_.find_closest_points(lines_, now, workers_);
  line_samples_.for_each_closest_point([&](const ClosestLinePoint& closest, double weight) {
    const bool is_weighted = options_.seam_weight && lines_.edges()[closest.edge].kind == LineKind::seam;
    fit.add(closest, is_weighted ? weight * *options_.seam_weight * weights.weight(closest.offset.norm()) : weight);
  });
  fit.add(origins_, weights, workers_);
  const BackwardOffsets backward(origins_, now, limits.near * unit, workers_);
  fit.hold_back(backward.offsets(), limits.most * unit);
  const bool keeps_shape = options_.shape_weight > 0;
  const double least_roundness = keeps_shape ? roundness(mesh_->at(positions_)) : 0;
  for (const auto& [relaxation, shape_factor] :
       keeps_shape ? std::span<const Step>(shape_steps) : std::span<const Step>(steps)) {
    start("moving", 0.7);
    fit.draw_to_middles(options_.shape_weight * shape_unit * shape_factor);
    std::vector<Vec3> moved = fit.moved(relaxation, workers_);
    take_back(mesh, backward, limits.most * unit, moved);
    start("measuring", 1);
    Distances distances = two_sided_distances(origins_, mesh.at(moved), workers_);
    if (!(weights.loss(distances) < weights.loss(distances_))) continue;
    if (keeps_shape && roundness(mesh.at(moved)) < least_roundness) continue;
    distances_ = std::move(distances);
    positions_ = std::move(moved);
    if (flipped) mesh_ = std::move(flipped);
    return true;
  }
  return false;
}

std::uint64_t Polisher::write(IndexedMesh& mesh) const {
  std::uint64_t n_moved = 0;
  const Frame& frame = original_.frame();
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    if (positions_[v] == frame.to_frame(mesh.positions[v])) continue;
    mesh.positions[v] = frame.to_model(positions_[v]);
    ++n_moved;
  }
  mesh.faces = mesh_->faces;
  return n_moved;
}

/// Without lines in the mesh, the original's border is not needed.
MeshLines Polisher::original_lines() const {
  workers_.update(0);
  std::vector<VertexPair> borders;
  if (!lines_.empty()) borders = detail::border_edges(original_.faces(), original_.positions().size());
  return lines_of(borders, options_.original_features, options_.original_seams, original_.positions().size());
}

void Polisher::start(std::string_view stage, double until) {
  if (until <= begun_until_) return;
  begun_until_ = until;
  meter_.start(stage, run_fraction(n_passes_ - 1 + until, options_));
}

/// Null if no edge was flipped.
std::unique_ptr<Connectivity> Polisher::flip() {
  if (!can_flip_) return nullptr;
  start("flipping edges", 0.25);
  std::vector<Triangle> faces = flip_edges(mesh_->at(positions_), mesh_->neighbors, mesh_->limits, lines_,
                                           {options_.regions, options_.shape_weight > 0}, origins_, workers_);
  if (faces == mesh_->faces) return nullptr;
  return std::make_unique<Connectivity>(std::move(faces), positions_.size(), options_, workers_);
}

/// Undoes moves that lower the total error but let a line or vertex drift, or make faces intersect.
/// \param most distance from the original that few vertices should have
void Polisher::take_back(const Connectivity& mesh, const BackwardOffsets& backward, double most,
                         std::vector<Vec3>& moved) {
  start("checking", 0.9);
  const Surface before = mesh.at(positions_);
  DriftedLines drifted(before, lines_, line_samples_, options_.feature_tolerance * original_.frame().scale);
  std::vector<Index> taken_back = drifted.take_back(moved, workers_);
  const std::vector<Index> drifted_vertices = take_back_drifted_vertices(backward, most, moved, workers_);
  taken_back.insert(taken_back.end(), drifted_vertices.begin(), drifted_vertices.end());
  take_back_intersections(before, mesh.limits, moved, taken_back, workers_);
  // Moving a vertex back moves its lines.
  while (lines_.has_inner() && !(taken_back = drifted.take_back(moved, workers_)).empty()) {
    take_back_intersections(before, mesh.limits, moved, taken_back, workers_);
  }
}

}  // namespace whittle::polishing
