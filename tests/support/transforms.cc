#include "support/transforms.hh"

#include <Eigen/Geometry>
#include <numbers>
#include <numeric>
#include <utility>

#include "support/random.hh"

namespace whittle::test {
namespace {

std::vector<Index> shuffled(std::size_t count, Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(i))]);
  return order;
}

template <class T>
std::vector<T> gathered(const std::vector<T>& values, const std::vector<Index>& order) {
  std::vector<T> result;
  if (values.empty()) return result;
  result.reserve(order.size());
  for (const Index i : order) result.push_back(values[i]);
  return result;
}

std::vector<Attribute> gathered(const std::vector<Attribute>& attributes, const std::vector<Index>& order) {
  std::vector<Attribute> result = attributes;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].values.clear();
    for (const Index from : order) {
      const auto value = attributes[i].value(from);
      result[i].values.insert(result[i].values.end(), value.begin(), value.end());
    }
  }
  return result;
}

}  // namespace

IndexedMesh rotated(const IndexedMesh& mesh, const Vec3& axis, double angle_deg) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
  IndexedMesh result = mesh;
  for (Vec3& p : result.positions) p = rotation * p;
  for (auto& normal : result.normals) {
    const Vec3 turned = rotation * Vec3(normal[0], normal[1], normal[2]);
    for (std::size_t i = 0; i < 3; ++i) normal[i] = static_cast<float>(turned[static_cast<Eigen::Index>(i)]);
  }
  return result;
}

IndexedMesh rotated(const IndexedMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  // The third coordinate stays away from 0, so the axis has a length. The axes need not be equally likely.
  const Vec3 axis = random.uniform_vector(-1, 1) + Vec3(0, 0, 1.1);
  const double angle_deg = random.uniform(20, 340);
  return rotated(mesh, axis, angle_deg);
}

IndexedMesh scaled(const IndexedMesh& mesh, double factor) {
  IndexedMesh result = mesh;
  for (Vec3& p : result.positions) p *= factor;
  return result;
}

IndexedMesh moved(const IndexedMesh& mesh, const Vec3& offset) {
  IndexedMesh result = mesh;
  for (Vec3& p : result.positions) p += offset;
  return result;
}

Permuted permuted(const IndexedMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  Permuted result;
  result.old_vertex = shuffled(mesh.positions.size(), random);
  result.old_face = shuffled(mesh.faces.size(), random);
  std::vector<Index> new_vertex(mesh.positions.size());
  for (Index v = 0; v < new_vertex.size(); ++v) new_vertex[result.old_vertex[v]] = v;

  IndexedMesh& out = result.mesh;
  out.positions = gathered(mesh.positions, result.old_vertex);
  out.normals = mesh.wedges.empty() ? gathered(mesh.normals, result.old_vertex) : mesh.normals;
  out.colors = mesh.wedges.empty() ? gathered(mesh.colors, result.old_vertex) : mesh.colors;
  out.attributes = mesh.wedges.empty() ? gathered(mesh.attributes, result.old_vertex) : mesh.attributes;
  out.face_attributes = gathered(mesh.face_attributes, result.old_face);
  out.face_groups = gathered(mesh.face_groups, result.old_face);
  out.group_names = mesh.group_names;
  for (const Index f : result.old_face) {
    const auto [a, b, c] = mesh.faces[f];
    out.faces.push_back({new_vertex[a], new_vertex[b], new_vertex[c]});
    if (mesh.wedges.empty()) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) out.wedges.push_back(mesh.wedges[3 * std::size_t{f} + corner]);
  }
  return result;
}

double diagonal(const IndexedMesh& mesh) {
  if (mesh.positions.empty()) return 0.0;
  Vec3 low = mesh.positions.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace whittle::test
