#include "cost_comparison.hh"

#include <algorithm>
#include <cmath>
#include <vector>

#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/spread_point.hh"
#include "whittle/core/geometry/symmetric_matrix.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle {
namespace {

constexpr std::size_t few_faces = 20'000;
constexpr std::size_t most_faces = 100'000;
constexpr double most_bent = 0.5;
constexpr double bent_per_vertex_left = 4;

/// Whether a vertex' faces lie in three planes or more. A small least eigenvalue is the determinant over the sum of the
/// minors. \param normals Σ n nᵀ over the unit normals of the faces
bool is_bent(const SymmetricMatrix& normals) {
  constexpr double least_angle = 0.01;
  const auto& [xx, xy, xz, yy, yz, zz] = normals;
  const double minors = xx * yy - xy * xy + yy * zz - yz * yz + xx * zz - xz * xz;
  const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return determinant > least_angle * least_angle * normals.trace() * minors;
}

/// Share of bent vertices, [0, 1].
double bent_share(const IndexedMesh& mesh) {
  std::vector<SymmetricMatrix> normals(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    const Vec3 normal = area_normal(mesh.positions, face).stableNormalized();
    for (const Index v : face) normals[v] += SymmetricMatrix::outer(normal, 1);
  }
  const auto n_bent = std::count_if(normals.begin(), normals.end(), is_bent);
  return normals.empty() ? 0 : static_cast<double>(n_bent) / static_cast<double>(normals.size());
}

constexpr std::size_t n_points = 2000;

/// Range of the input's diagonal: trees take fourth powers of lengths.
constexpr double least_size = 1e-60;
constexpr double most_size = 1e60;

/// Points of the surface, each for an equal part of the area; none without area.
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

bool is_worth_plain_quadrics(const IndexedMesh& mesh, const DecimateTarget& target) {
  if (mesh.faces.empty() || mesh.faces.size() > most_faces || target.cost_limit() || target.error_limit()) return false;
  if (mesh.faces.size() <= few_faces) return true;
  bounds_of(mesh);  // refuses invalid meshes
  const double bent = bent_share(mesh);
  return bent <= most_bent && bent <= bent_per_vertex_left * target.share_of(mesh.faces.size(), mesh.positions.size());
}

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
