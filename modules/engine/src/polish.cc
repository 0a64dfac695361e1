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
}

std::vector<std::uint8_t> fixed_vertices(const FaceNeighbors& neighbors, std::size_t n_vertices,
                                         std::span<const std::uint8_t> locked) {
  std::vector<std::uint8_t> is_fixed(n_vertices);
  for (Index v = 0; v < n_vertices; ++v) {
    const bool is_locked = !locked.empty() && locked[v] != 0;
    is_fixed[v] = is_locked || neighbors.fan(v) != Fan::closed;
  }
  return is_fixed;
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
  const std::vector<std::uint8_t> is_fixed = fixed_vertices(neighbors, mesh.positions.size(), options.locked);
  std::vector<Vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) positions.push_back(frame.to_frame(p));
  const std::vector<Vec3> before = positions;

  const VertexCorners original_corners(original);
  const TwoSidedError error({original.faces, original_corners, samples.positions()}, vertex_map, mesh.faces, corners);
  FootFinder finder(mesh.faces, corners);
  SurfaceFit fit(mesh.faces, corners, neighbors, is_fixed);
  PolishResult result;
  double least = error.mean_square(positions, options.threads);
  result.rms_before = std::sqrt(least) * frame.unscale;
  for (; result.n_passes < options.passes; ++result.n_passes) {
    finder.look_at(positions, options.threads);
    samples.find_feet(finder, options.threads);
    std::vector<Vec3> moved = positions;
    fit.start(moved);
    samples.for_each_foot([&fit](const Foot& foot, double weight) { fit.add(foot, weight); });
    for (int i = 0; i < n_sweeps; ++i) fit.sweep();
    take_back_intersections({mesh.faces, corners, positions}, neighbors, moved, options.threads);
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
