// Radius ratio of a triangle with sides a, b, c, area A and half perimeter s: 2r/R = 8 A² / (s a b c), as r = A/s and
// R = abc/(4A).
#include "whittle/metrics/shape.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "edge_normals.hh"
#include "whittle/core/geometry/bounds.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

constexpr double degenerate_radius_ratio = 1e-6;
constexpr double fold_cosine = -0.94;

struct Quality {
  double radius_ratio;
  double min_angle_deg;
};

Quality quality(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  std::array<Vec3, 3> sides{p1 - p0, p2 - p1, p0 - p2};
  std::sort(sides.begin(), sides.end(), [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); });
  const double longest = sides[2].norm();
  if (!(longest > 0.0)) return {0.0, 0.0};
  for (Vec3& side : sides) side /= longest;  // so that no power of a length under- or overflows
  const double a = sides[0].norm(), b = sides[1].norm(), c = 1.0;
  const double twice_area = sides[0].cross(sides[1]).norm();
  const double half_perimeter = 0.5 * (a + b + c);
  // The sides run around the triangle. So the angle opposite the shortest one is that between one longer side and the
  // reverse of the other.
  const double least_angle = std::atan2(sides[1].cross(sides[2]).norm(), -sides[1].dot(sides[2]));
  const double ratio = a > 0.0 ? 2.0 * twice_area * twice_area / (half_perimeter * a * b * c) : 0.0;
  return {std::min(ratio, 1.0), least_angle * 180.0 / std::numbers::pi};
}

void measure_faces(const IndexedMesh& mesh, Shape& result) {
  double ratio_sum = 0.0, angle_sum = 0.0;
  result.radius_ratio_min = 1.0;
  result.min_angle_min_deg = 60.0;
  for (const auto& [v0, v1, v2] : mesh.faces) {
    const auto [ratio, angle] = quality(mesh.positions[v0], mesh.positions[v1], mesh.positions[v2]);
    ratio_sum += ratio;
    angle_sum += angle;
    result.radius_ratio_min = std::min(result.radius_ratio_min, ratio);
    result.min_angle_min_deg = std::min(result.min_angle_min_deg, angle);
    const std::size_t n_parts = result.radius_ratio_histogram.size();
    ++result.radius_ratio_histogram[std::min(n_parts - 1,
                                             static_cast<std::size_t>(ratio * static_cast<double>(n_parts)))];
    if (ratio < degenerate_radius_ratio) ++result.degenerate_faces;
  }
  result.radius_ratio_mean = ratio_sum / static_cast<double>(mesh.faces.size());
  result.min_angle_mean_deg = angle_sum / static_cast<double>(mesh.faces.size());
}

void measure_edge_lengths(const IndexedMesh& mesh, const detail::EdgeTable& edges, Shape& result) {
  if (edges.size() == 0) return;
  const auto n = static_cast<double>(edges.size());
  const auto length = [&](std::size_t e) { return (mesh.positions[edges[e].b] - mesh.positions[edges[e].a]).norm(); };
  double sum = 0.0;
  for (std::size_t e = 0; e < edges.size(); ++e) sum += length(e);
  const double mean = sum / n;
  double variance = 0.0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double ratio = length(e) / mean - 1.0;
    variance += ratio * ratio;
  }
  result.edge_length_mean = mean;
  result.edge_length_cv = mean > 0.0 ? std::sqrt(variance / n) : 0.0;
}

bool is_fold(const IndexedMesh& mesh, const detail::EdgeTable& edges, std::size_t e) {
  const auto normals = normals_at(mesh, edges, e);
  return normals && (*normals)[0].dot((*normals)[1]) < fold_cosine;
}

ValenceStats measure_valences(const IndexedMesh& mesh, const detail::EdgeTable& edges) {
  std::vector<std::size_t> valence(mesh.positions.size(), 0);
  std::vector<bool> at_boundary(mesh.positions.size(), false);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const Index v : {edges[e].a, edges[e].b}) {
      ++valence[v];
      if (edges.sides(e).size() == 1) at_boundary[v] = true;
    }
  }
  ValenceStats result;
  std::size_t regular = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0 || at_boundary[v]) continue;
    ++result.vertices;
    ++result.histogram[valence[v]];
    if (valence[v] >= 5 && valence[v] <= 7) ++regular;
  }
  if (result.vertices > 0) {
    result.min = result.histogram.begin()->first;
    result.max = result.histogram.rbegin()->first;
    result.share_5_to_7 = static_cast<double>(regular) / static_cast<double>(result.vertices);
  }
  return result;
}

}  // namespace

Shape shape(const IndexedMesh& mesh) {
  if (const double scale = working_scale({bounds_of(mesh)}); scale != 1.0) {
    Shape result = shape(scaled(mesh, scale));
    result.edge_length_mean /= scale;
    return result;
  }
  Shape result;
  measure_faces(mesh, result);
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  measure_edge_lengths(mesh, edges, result);
  for (std::size_t e = 0; e < edges.size(); ++e) result.folds += is_fold(mesh, edges, e) ? 1 : 0;
  result.valence = measure_valences(mesh, edges);
  return result;
}

}  // namespace whittle::metrics
