#include "whittle/polish/polish.hh"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "fit/surface_fit.hh"
#include "fit/two_sided_error.hh"
#include "flips/edge_flips.hh"
#include "guard/new_intersections.hh"
#include "surface/face_neighbors.hh"
#include "surface/foot_finder.hh"
#include "surface/surface_samples.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/detail/vertex_corners.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {
namespace {

constexpr int n_sweeps = 2;

/// Faces of the simplified mesh to one of the original above which a point a face is too few to fit it.
constexpr double dense = 0.3;

void check_edges(std::span<const VertexPair> edges, std::size_t n_vertices) {
  const auto is_known = [n_vertices](const VertexPair& edge) { return std::max(edge.a, edge.b) < n_vertices; };
  if (!std::all_of(edges.begin(), edges.end(), is_known)) {
    throw std::invalid_argument("polish: a feature edge names a vertex that isn't there");
  }
}

void check(const IndexedMesh& original, std::span<const Index> vertex_map, const IndexedMesh& mesh,
           const PolishOptions& options) {
  check_corners(original.positions.size(), original.faces);
  check_corners(mesh.positions.size(), mesh.faces);
  if (vertex_map.size() != original.positions.size()) {
    throw std::invalid_argument("polish: vertex_map has another length than the original's vertices");
  }
  for (const Index v : vertex_map) {
    if (v == invalid_index || v < mesh.positions.size()) continue;
    throw std::invalid_argument("polish: vertex_map names vertex " + std::to_string(v) + " of " +
                                std::to_string(mesh.positions.size()));
  }
  if (!options.locked.empty() && options.locked.size() != mesh.positions.size()) {
    throw std::invalid_argument("polish: locked has another length than the vertices");
  }
  check_edges(options.features, mesh.positions.size());
  check_edges(options.original_features, original.positions.size());
  if (!(options.feature_angle_deg > 0 && options.feature_angle_deg <= 180)) {
    throw std::invalid_argument("polish: feature_angle_deg is not in (0, 180]");
  }
  if (!(options.min_radius_ratio >= 0 && options.min_radius_ratio <= 1)) {
    throw std::invalid_argument("polish: min_radius_ratio is not in [0, 1]");
  }
}

/// The border, and those of the features that have two faces.
MeshLines lines_of(const IndexedMesh& mesh, const FaceNeighbors& neighbors, std::span<const VertexPair> features) {
  std::vector<VertexPair> inner;
  for (const auto& [a, b] : features) {
    if (neighbors.inner_side(a, b).face != invalid_index) inner.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(inner.begin(), inner.end());
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  return MeshLines(border_edges(mesh.faces, mesh.positions.size()), inner, mesh.positions.size());
}

/// Vertices stay that are locked, where the mesh isn't manifold, and where lines end or meet.
std::vector<std::uint8_t> fixed_vertices(const FaceNeighbors& neighbors, const MeshLines& lines, std::size_t n_vertices,
                                         const PolishOptions& options) {
  std::vector<std::uint8_t> is_fixed(n_vertices);
  for (Index v = 0; v < n_vertices; ++v) {
    const Fan fan = neighbors.fan(v);
    const std::size_t n_lines = lines.empty() ? 0 : lines.at(v).size();
    is_fixed[v] = (!options.locked.empty() && options.locked[v] != 0) || fan == Fan::none ||
                  (fan == Fan::open && !options.fit_borders) || (n_lines != 0 && n_lines != 2);
  }
  return is_fixed;
}

/// Puts vertices back to where they were whose lines are further from the original's than these were anywhere.
/// \return these vertices
std::vector<Index> take_back_lines(const Surface& before, const MeshLines& lines, LineSamples& samples,
                                   std::vector<Vec3>& positions, unsigned threads) {
  if (lines.empty()) return {};
  constexpr double rounding = 1e-9;
  const std::vector<double> distances = samples.distances(lines, before.positions);
  const double most = (1 + rounding) * *std::max_element(distances.begin(), distances.end());
  std::vector<Index> taken_back;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    samples.find_feet(lines, {before.faces, before.corners, positions}, threads);
    const std::vector<double> now = samples.distances(lines, positions);
    for (Index v = 0; v < now.size(); ++v) {
      if (!(now[v] > most) || positions[v] == before.positions[v]) continue;
      positions[v] = before.positions[v];
      taken_back.push_back(v);
      is_done = false;
    }
  }
  return taken_back;
}

using Distances = std::vector<TwoSidedError::Distance>;

double root_mean_square(const Distances& distances) {
  double sum = 0;
  for (const auto& [square, weight] : distances) sum += weight * square;
  return std::sqrt(sum);
}

/// How much a point at a distance counts. \cite holland_1977_robust
double fair_weight(double distance, double unit) { return 1 / (1 + std::abs(distance) / unit); }

/// What Fair's weights make least: like half the squares of distances far below the unit, like distances far above.
double fair_loss(const Distances& distances, double unit) {
  double sum = 0;
  for (const auto& [square, weight] : distances) {
    const double x = std::sqrt(square) / unit;
    sum += weight * (x - std::log1p(x));
  }
  return sum;
}

/// How a mesh hangs together, and what is computed by that. Its parts refer to each other.
struct Connectivity {
  std::vector<Triangle> faces;
  VertexCorners corners;
  FaceNeighbors neighbors;
  FaceLimits limits;
  TwoSidedError error;

  Connectivity(std::vector<Triangle> the_faces, std::size_t n_vertices, const SimplifiedSurface& original,
               const PolishOptions& options)
      : faces(std::move(the_faces)),
        corners(faces, n_vertices),
        neighbors(faces, corners),
        limits(neighbors, options.features, options.feature_angle_deg, options.min_radius_ratio),
        error(original, faces, n_vertices) {}
  Connectivity(const Connectivity&) = delete;
  Connectivity& operator=(const Connectivity&) = delete;

  Surface at(std::span<const Vec3> positions) const { return {faces, corners, positions}; }
  Distances distances(std::span<const Vec3> positions, unsigned threads) const {
    return error.distances(at(positions), threads);
  }
};

class Polisher {
 public:
  Polisher(const IndexedMesh& original, std::span<const Index> vertex_map, const IndexedMesh& mesh,
           const PolishOptions& options)
      : options_(options),
        frame_(Frame::of_points(original.positions)),
        samples_(original, vertex_map, frame_, points_per_face(original, mesh), options.threads),
        original_{original.faces, samples_.positions(), vertex_map},
        mesh_(std::make_unique<Connectivity>(mesh.faces, mesh.positions.size(), original_, options)),
        groups_(mesh.face_groups),
        lines_(lines_of(mesh, mesh_->neighbors, options.features)),
        line_samples_(original_lines(original), samples_.positions(), vertex_map),
        is_fixed_(fixed_vertices(mesh_->neighbors, lines_, mesh.positions.size(), options)),
        can_flip_(options.flips && mesh.corner_texcoords.empty()) {
    positions_.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions) positions_.push_back(frame_.to_frame(p));
    distances_ = mesh_->distances(positions_, options.threads);
  }

  /// \return whether it helped; if not, nothing has changed
  bool pass() {
    const double unit = root_mean_square(distances_);
    if (!(unit > 0)) return false;
    FootFinder finder(mesh_->faces, mesh_->corners);
    finder.look_at(positions_, options_.threads);
    samples_.find_feet(finder, options_.threads);
    line_samples_.find_feet(lines_, mesh_->at(positions_), options_.threads);
    std::unique_ptr<Connectivity> flipped = flip();
    const Connectivity& mesh = flipped ? *flipped : *mesh_;
    std::vector<Vec3> moved = move(mesh, unit);
    Distances distances = mesh.distances(moved, options_.threads);
    if (!(fair_loss(distances, unit) < fair_loss(distances_, unit))) return false;
    distances_ = std::move(distances);
    positions_ = std::move(moved);
    if (flipped) mesh_ = std::move(flipped);
    return true;
  }

  double rms() const { return root_mean_square(distances_) * frame_.unscale; }

  /// \return how many vertices are not where they were
  std::uint64_t write(IndexedMesh& mesh) const {
    std::uint64_t n_moved = 0;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (positions_[v] == frame_.to_frame(mesh.positions[v])) continue;
      mesh.positions[v] = frame_.to_model(positions_[v]);
      ++n_moved;
    }
    mesh.faces = mesh_->faces;
    if (!mesh.normals.empty()) mesh.normals = vertex_normals(mesh, frame_);
    return n_moved;
  }

 private:
  static std::size_t points_per_face(const IndexedMesh& original, const IndexedMesh& mesh) {
    return static_cast<double>(mesh.faces.size()) > dense * static_cast<double>(original.faces.size()) ? 4 : 1;
  }

  MeshLines original_lines(const IndexedMesh& original) const {
    std::vector<VertexPair> borders;
    if (!lines_.empty()) borders = border_edges(original.faces, original.positions.size());
    return MeshLines(borders, options_.original_features, original.positions.size());
  }

  /// Nothing if no edge was flipped.
  std::unique_ptr<Connectivity> flip() {
    if (!can_flip_) return nullptr;
    std::vector<Triangle> faces =
        flip_edges(mesh_->at(positions_), mesh_->neighbors, mesh_->limits, lines_, groups_, samples_, options_.threads);
    if (faces == mesh_->faces) return nullptr;
    return std::make_unique<Connectivity>(std::move(faces), positions_.size(), original_, options_);
  }

  /// Where the vertices are to go. \param unit of Fair's weights
  std::vector<Vec3> move(const Connectivity& mesh, double unit) {
    std::vector<Vec3> moved = positions_;
    SurfaceFit fit(mesh.faces, mesh.corners, mesh.neighbors, mesh.limits, lines_, is_fixed_);
    fit.start(moved);
    line_samples_.for_each_foot([&fit](const LineFoot& foot, double weight) { fit.add(foot, weight); });
    samples_.for_each_foot(
        [&fit, unit](const Foot& foot, double weight) { fit.add(foot, weight * fair_weight(foot.distance, unit)); });
    for (int i = 0; i < n_sweeps; ++i) fit.sweep();
    const Surface before = mesh.at(positions_);
    const std::vector<Index> taken_back = take_back_lines(before, lines_, line_samples_, moved, options_.threads);
    take_back_intersections(before, mesh.limits, moved, taken_back, options_.threads);
    return moved;
  }

  const PolishOptions& options_;
  Frame frame_;
  SurfaceSamples samples_;
  SimplifiedSurface original_;
  std::unique_ptr<Connectivity> mesh_;
  std::span<const Index> groups_;
  MeshLines lines_;
  LineSamples line_samples_;
  std::vector<std::uint8_t> is_fixed_;
  bool can_flip_;
  std::vector<Vec3> positions_;
  Distances distances_;
};

}  // namespace

PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options) {
  check(original, vertex_map, mesh, options);
  if (options.passes == 0 || mesh.faces.empty() || original.faces.empty()) return {};
  Polisher polisher(original, vertex_map, mesh, options);
  PolishResult result;
  result.rms_before = polisher.rms();
  while (result.n_passes < options.passes && polisher.pass()) ++result.n_passes;
  result.rms_after = polisher.rms();
  if (result.n_passes > 0) result.n_moved = polisher.write(mesh);
  return result;
}

}  // namespace whittle
