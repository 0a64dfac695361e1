#include "pose/posable_mesh.hh"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

/// The number of a morph target by the name of its attribute: "target 3 POSITION".
std::optional<std::size_t> target_of(std::string_view name) {
  constexpr std::string_view beginning = "target ";
  constexpr std::string_view ending = " POSITION";
  if (!name.starts_with(beginning) || !name.ends_with(ending)) return {};
  if (name.size() <= beginning.size() + ending.size()) return {};
  name = name.substr(beginning.size(), name.size() - beginning.size() - ending.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc{} || end != name.data() + name.size()) return {};
  return number;
}

/// A wedge of each vertex. All wedges of a vertex have the same joints and displacements.
std::vector<Index> wedge_of_vertices(const IndexedMesh& mesh) {
  std::vector<Index> wedges(mesh.positions.size());
  std::iota(wedges.begin(), wedges.end(), Index{0});
  if (mesh.wedges.empty()) return wedges;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) wedges[mesh.faces[f][c]] = mesh.wedge(f, c);
  }
  return wedges;
}

void read_joints(const Attribute& attribute, std::span<const Index> wedges, const std::string& what,
                 const std::string& file, PosableMesh& to) {
  const std::size_t n = to.n_influences = attribute.n_components / 2;
  to.joints.reserve(wedges.size() * n);
  to.weights.reserve(wedges.size() * n);
  for (const Index wedge : wedges) {
    const std::span<const double> joints = attribute.value(wedge).first(n);
    const std::span<const double> weights = attribute.value(wedge).last(n);
    double sum = 0;
    for (const double weight : weights) sum += std::max(weight, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const bool counts = weights[i] > 0;
      if (counts && !(joints[i] >= 0 && joints[i] < invalid_index)) {
        throw io::ReadError(file, what + ": a joint is not a whole number from 0 on");
      }
      to.weights.push_back(counts ? weights[i] / sum : 0);
      to.joints.push_back(counts ? static_cast<Index>(joints[i]) : 0);
      if (counts) to.n_joints = std::max(to.n_joints, std::size_t{to.joints.back()} + 1);
    }
  }
}

std::vector<Vec3> read_displacements(const Attribute& attribute, std::span<const Index> wedges) {
  std::vector<Vec3> displacements;
  displacements.reserve(wedges.size());
  for (const Index wedge : wedges) displacements.emplace_back(attribute.value(wedge).data());
  return displacements;
}

}  // namespace

PosableMesh posable_mesh(IndexedMesh mesh, const std::string& what, const std::string& file) {
  PosableMesh posable;
  const std::vector<Index> wedges = wedge_of_vertices(mesh);
  for (const Attribute& attribute : mesh.attributes) {
    if (attribute.kind == AttributeKind::joint_weights && posable.n_influences == 0) {
      read_joints(attribute, wedges, what, file, posable);
    } else if (attribute.kind == AttributeKind::displacement && attribute.n_components == 3) {
      const std::optional<std::size_t> target = target_of(attribute.name);
      if (!target) continue;
      if (*target >= posable.displacements.size()) posable.displacements.resize(*target + 1);
      posable.displacements[*target] = read_displacements(attribute, wedges);
    }
  }
  posable.positions = std::move(mesh.positions);
  posable.faces = std::move(mesh.faces);
  return posable;
}

std::vector<Vec3> apply_targets(const PosableMesh& mesh, std::span<const double> weights) {
  std::vector<Vec3> positions = mesh.positions;
  const std::size_t n = std::min(weights.size(), mesh.displacements.size());
  for (std::size_t t = 0; t < n; ++t) {
    const std::vector<Vec3>& displacements = mesh.displacements[t];
    if (displacements.empty() || weights[t] == 0) continue;
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] += weights[t] * displacements[v];
  }
  return positions;
}

void apply_matrix(std::span<Vec3> positions, const Eigen::Matrix4d& matrix) {
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  const Vec3 translation = matrix.topRightCorner<3, 1>();
  for (Vec3& p : positions) p = linear * p + translation;
}

void apply_skin(const PosableMesh& mesh, std::span<const Eigen::Matrix4d> joints, const Eigen::Matrix4d& matrix,
                std::span<Vec3> positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const std::size_t first = v * mesh.n_influences;
    Vec3 moved = Vec3::Zero();
    double sum = 0;
    for (std::size_t i = first; i < first + mesh.n_influences; ++i) {
      const double weight = mesh.weights[i];
      if (weight == 0) continue;
      Vec3 by_joint = positions[v];
      apply_matrix(std::span(&by_joint, 1), joints[mesh.joints[i]]);
      moved += weight * by_joint;
      sum += weight;
    }
    if (sum > 0) {
      positions[v] = moved;
    } else {
      apply_matrix(positions.subspan(v, 1), matrix);
    }
  }
}

}  // namespace whittle::gltf
