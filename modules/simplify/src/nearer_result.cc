#include "nearer_result.hh"

#include <cmath>
#include <vector>

#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/spread_point.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle {
namespace {

constexpr std::size_t n_points = 2000;

/// Of the input: trees take fourth powers of lengths.
constexpr double least_size = 1e-60;
constexpr double most_size = 1e60;

/// Points of the surface, each for an equal part of the area. None if there is no area.
std::vector<Vec3> spread_points(const IndexedMesh& mesh) {
  double area = 0;
  for (const Triangle& face : mesh.faces) area += area_of(mesh.positions, face);
  std::vector<Vec3> points;
  if (!(area > 0 && std::isfinite(area))) return points;
  const double step = area / static_cast<double>(n_points);
  double behind = 0;
  for (const Triangle& face : mesh.faces) {
    behind += area_of(mesh.positions, face);
    while (points.size() < n_points && (static_cast<double>(points.size()) + 0.5) * step <= behind) {
      points.push_back(point_at(corners_of(mesh.positions, face), spread_point(points.size())));
    }
  }
  return points;
}

double mean_distance(const std::vector<Vec3>& points, const TriangleTree& tree) {
  double sum = 0;
  Index last = invalid_index;
  for (const Vec3& point : points) {
    const ClosestPoint nearest = tree.nearest(point, last);
    sum += (nearest.point - point).norm();
    last = nearest.face;
  }
  return sum / static_cast<double>(points.size());
}

}  // namespace

bool is_nearer(const IndexedMesh& input, const IndexedMesh& a, const IndexedMesh& b) {
  const double size = diagonal_of(input.positions);
  if (!(size > least_size && size < most_size)) return false;
  const std::vector<Vec3> of_input = spread_points(input);
  const std::vector<Vec3> of_a = spread_points(a);
  const std::vector<Vec3> of_b = spread_points(b);
  if (of_input.empty() || of_a.empty() || of_b.empty()) return false;
  const TriangleTree tree(input);
  const double distance_a = mean_distance(of_input, TriangleTree(a)) + mean_distance(of_a, tree);
  const double distance_b = mean_distance(of_input, TriangleTree(b)) + mean_distance(of_b, tree);
  return distance_a < distance_b;
}

}  // namespace whittle
