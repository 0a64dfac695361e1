#include "mesh_comparison.hh"

#include <algorithm>
#include <limits>
#include <ranges>

namespace whittle::gltf::test {
namespace {

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

}  // namespace whittle::gltf::test
