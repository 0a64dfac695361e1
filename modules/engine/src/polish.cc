#include "whittle/engine/polish.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "checks.hh"
#include "face_neighbors.hh"
#include "foot_finder.hh"
#include "new_intersections.hh"
#include "surface_fit.hh"
#include "surface_samples.hh"
#include "two_sided_error.hh"
#include "vertex_corners.hh"
#include "vertex_normals.hh"
#include "whittle/engine/frame.hh"

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

}  // namespace

PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options) {
  check(original, vertex_map, mesh, options);
  if (options.passes == 0 || mesh.faces.empty() || original.faces.empty()) return {};
  const Frame frame = Frame::of_points(original.positions);
  const bool is_dense = static_cast<double>(mesh.faces.size()) > dense * static_cast<double>(original.faces.size());
  SurfaceSamples samples(original, vertex_map, frame, is_dense ? 4 : 1, options.threads);
  const VertexCorners corners(mesh);
  const FaceNeighbors neighbors(mesh.faces, corners);
  const TurnLimits limits(neighbors, options.features, options.feature_angle_deg);
  const MeshLines lines = lines_of(mesh, neighbors, options.features);
  const std::vector<std::uint8_t> is_fixed = fixed_vertices(neighbors, lines, mesh.positions.size(), options);
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) positions.push_back(frame.to_frame(p));
  const std::vector<Vec3> before = positions;

  std::vector<VertexPair> original_borders;
  if (!lines.empty()) original_borders = border_edges(original.faces, original.positions.size());
  const MeshLines original_lines(original_borders, options.original_features, original.positions.size());
  LineSamples line_samples(original_lines, samples.positions(), vertex_map);

  const VertexCorners original_corners(original);
  const TwoSidedError error({original.faces, original_corners, samples.positions()}, vertex_map, mesh.faces, corners);
  FootFinder finder(mesh.faces, corners);
  SurfaceFit fit(mesh.faces, corners, neighbors, limits, lines, is_fixed);
  PolishResult result;
  double least = error.mean_square(positions, options.threads);
  result.rms_before = std::sqrt(least) * frame.unscale;
  for (; result.n_passes < options.passes; ++result.n_passes) {
    finder.look_at(positions, options.threads);
    samples.find_feet(finder, options.threads);
    std::vector<Vec3> moved = positions;
    fit.start(moved);
    line_samples.find_feet(lines, {mesh.faces, corners, positions}, options.threads);
    line_samples.for_each_foot([&fit](const LineFoot& foot, double weight) { fit.add(foot, weight); });
    samples.for_each_foot([&fit](const Foot& foot, double weight) { fit.add(foot, weight); });
    for (int i = 0; i < n_sweeps; ++i) fit.sweep();
    const std::vector<Index> taken_back =
        take_back_lines({mesh.faces, corners, positions}, lines, line_samples, moved, options.threads);
    take_back_intersections({mesh.faces, corners, positions}, limits, moved, taken_back, options.threads);
    const double now = error.mean_square(moved, options.threads);
    if (!(now < least)) break;
    least = now;
    positions = std::move(moved);
  }
  result.rms_after = std::sqrt(least) * frame.unscale;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (positions[v] == before[v]) continue;
    mesh.positions[v] = frame.to_model(positions[v]);
    ++result.n_moved;
  }
  if (!mesh.normals.empty()) mesh.normals = vertex_normals(mesh, frame);
  return result;
}

}  // namespace whittle
