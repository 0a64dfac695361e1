#include "mesh_comparison.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include "whittle/core/geometry/box.hh"
#include "whittle/gltf/pose.hh"

namespace whittle::gltf::test {
namespace {

/// Moments of animations that are compared.
constexpr std::size_t n_moments = 2;
/// A step is 3e-5 of a side.
constexpr double tolerance = 1e-4;
/// With weights of 8 bits.
constexpr double skinned_tolerance = 1e-3;

std::vector<Vec3> in_order(std::vector<Vec3> positions) {
  std::ranges::sort(positions, [](const Vec3& p, const Vec3& q) { return std::ranges::lexicographical_compare(p, q); });
  return positions;
}

}  // namespace

double largest_difference(const IndexedMesh& a, const IndexedMesh& b) {
  if (a.positions.size() != b.positions.size()) return std::numeric_limits<double>::infinity();
  const std::vector<Vec3> of_a = in_order(a.positions);
  const std::vector<Vec3> of_b = in_order(b.positions);
  double largest = 0;
  for (std::size_t v = 0; v < of_a.size(); ++v) largest = std::max(largest, (of_a[v] - of_b[v]).cwiseAbs().maxCoeff());
  return largest;
}

bool are_positions_same(const IndexedMesh& a, const IndexedMesh& b) {
  return std::ranges::equal(a.positions, b.positions,
                            [](const Vec3& p, const Vec3& q) { return p.cast<float>() == q.cast<float>(); });
}

Vec3 mean_corner(const IndexedMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) sum += mesh.positions[v];
  }
  return sum / static_cast<double>(3 * mesh.faces.size());
}

std::vector<double> mean_value(const IndexedMesh& mesh, const Attribute& attribute) {
  std::vector<double> sum(attribute.n_components);
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += attribute.value(v)[k];
    }
  }
  for (double& x : sum) x /= static_cast<double>(3 * mesh.faces.size());
  return sum;
}

std::vector<double> corners_along(int axis, const IndexedMesh& mesh) {
  std::vector<double> values;
  values.reserve(3 * mesh.faces.size());
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) values.push_back(mesh.positions[v][axis]);
  }
  std::ranges::sort(values);
  return values;
}

Asset replaced(Asset asset) {
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) > 0) asset.set_triangles(m, asset.triangles(m));
  }
  return asset;
}

Json document_of(const Asset& asset) { return Json::parse(asset.document()); }

double relative_distance(const IndexedMesh& a, const IndexedMesh& b) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> of_a = corners_along(axis, a);
    const std::vector<double> of_b = corners_along(axis, b);
    EXPECT_EQ(of_a.size(), of_b.size());
    for (std::size_t i = 0; i < std::min(of_a.size(), of_b.size()); ++i) {
      farthest = std::max(farthest, std::abs(of_a[i] - of_b[i]));
    }
  }
  const double diagonal = diagonal_of(a.positions);
  return diagonal > 0 ? farthest / diagonal : farthest;
}

void expect_same_poses(const Asset& a, const Asset& b) {
  const Poser of_a(a);
  const Poser of_b(b);
  const double limit = of_a.has_skins() ? skinned_tolerance : tolerance;
  EXPECT_LE(relative_distance(of_a.mesh(of_a.rest()), of_b.mesh(of_b.rest())), limit);
  if (!of_a.is_animated()) return;
  for (const AnimationTime& moment : of_a.moments(n_moments)) {
    EXPECT_LE(relative_distance(of_a.mesh(of_a.animated(moment)), of_b.mesh(of_b.animated(moment))), limit);
  }
}

}  // namespace whittle::gltf::test
