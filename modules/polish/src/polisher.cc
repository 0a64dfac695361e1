#include "polisher.hh"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "fit/surface_fit.hh"
#include "flips/edge_flips.hh"
#include "guard/new_intersections.hh"
#include "guard/outliers.hh"
#include "guard/strayed_lines.hh"
#include "original/backward_offsets.hh"
#include "original/foot_finder.hh"
#include "whittle/core/detail/edge_table.hh"

namespace whittle::polishing {
namespace {

/// As a face moves, its points get other feet, which they pull to, too. So the step to where the present feet fit best
/// is too short. Where the longer step goes too far, the shorter one is tried.
constexpr std::array relaxations{1.5, 1.0};

/// What is held down, in root mean square distances.
struct Limits {
  double near;  ///< a vertex is near the original, and not held back: it would be by a thousandth at most
  double most;  ///< few vertices should be so far off. They are held back steeply
  double
      far_forward;  ///< few of the original's points should be so far off; infinite: they count as Fair's weights say
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

/// Where the simplified mesh has more than this share of the original's faces, one point a face is too few to fit it.
constexpr double dense = 0.3;

/// Distances of this root mean square are rounding errors: the mesh is as good as the original. A fraction of the size
/// of both meshes, which is about 1 in their frame.
constexpr double rounding = 1e-14;

/// Time for the preparations, as a share of a pass.
constexpr double preparation = 0.25;

/// The border, and those features that have two faces.
MeshLines lines_of(const IndexedMesh& mesh, const FaceNeighbors& neighbors, std::span<const VertexPair> features,
                   const detail::Workers& workers) {
  workers.update(0);
  std::vector<VertexPair> inner;
  for (const auto& [a, b] : features) {
    if (neighbors.inner_side(a, b).face != invalid_index) inner.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(inner.begin(), inner.end());
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  return MeshLines(detail::border_edges(mesh.faces, mesh.positions.size()), inner, mesh.positions.size());
}

/// Locked vertices are fixed, and those where the mesh is not manifold, and where lines end or meet.
std::vector<std::uint8_t> fixed_vertices(const FaceNeighbors& neighbors, const MeshLines& lines, std::size_t n_vertices,
                                         const PolishOptions& options, const detail::Workers& workers) {
  std::vector<std::uint8_t> is_fixed(n_vertices);
  for_each_range(n_vertices, workers, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Fan fan = neighbors.fan(v);
      const std::size_t n_lines = lines.empty() ? 0 : lines.at(v).size();
      is_fixed[v] = (!options.locked.empty() && options.locked[v] != 0) || fan == Fan::none ||
                    (fan == Fan::open && !options.fit_borders) || (n_lines != 0 && n_lines != 2);
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
      lines_(lines_of(mesh, mesh_->neighbors, options.features, workers_)),
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
  line_samples_.find_feet(lines_, now, workers_);
  line_samples_.for_each_foot([&fit](const LineFoot& foot, double weight) { fit.add(foot, weight); });
  fit.add(origins_, weights, workers_);
  const BackwardOffsets backward(origins_, now, limits.near * unit, workers_);
  fit.hold_back(backward.offsets(), limits.most * unit);
  for (const double relaxation : relaxations) {
    start("moving", 0.7);
    std::vector<Vec3> moved = fit.moved(relaxation, workers_);
    take_back(mesh, backward, limits.most * unit, moved);
    start("measuring", 1);
    Distances distances = two_sided_distances(origins_, mesh.at(moved), workers_);
    if (!(weights.loss(distances) < weights.loss(distances_))) continue;
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
  return MeshLines(borders, options_.original_features, original_.positions().size());
}

void Polisher::start(std::string_view stage, double until) {
  if (until <= begun_until_) return;
  begun_until_ = until;
  meter_.start(stage, run_fraction(n_passes_ - 1 + until, options_));
}

/// Nothing if no edge was flipped.
std::unique_ptr<Connectivity> Polisher::flip() {
  if (!can_flip_) return nullptr;
  start("flipping edges", 0.25);
  std::vector<Triangle> faces =
      flip_edges(mesh_->at(positions_), mesh_->neighbors, mesh_->limits, lines_, options_.regions, origins_, workers_);
  if (faces == mesh_->faces) return nullptr;
  return std::make_unique<Connectivity>(std::move(faces), positions_.size(), options_, workers_);
}

/// Puts vertices back whose moves the sums don't forbid, though they do harm.
/// \param most distance from the original that few vertices should have
void Polisher::take_back(const Connectivity& mesh, const BackwardOffsets& backward, double most,
                         std::vector<Vec3>& moved) {
  start("checking", 0.9);
  const Surface before = mesh.at(positions_);
  std::vector<Index> taken_back = take_back_strayed_lines(before, lines_, line_samples_, moved, workers_);
  const std::vector<Index> outliers = take_back_outliers(backward, most, moved, workers_);
  taken_back.insert(taken_back.end(), outliers.begin(), outliers.end());
  take_back_intersections(before, mesh.limits, moved, taken_back, workers_);
}

}  // namespace whittle::polishing
