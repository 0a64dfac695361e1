#include "geometry/instances.hh"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "geometry/elements.hh"

namespace whittle::gltf {
namespace {

std::size_t n_instances(const Model& model, const Node& node) {
  if (node.instances.empty()) return 1;
  std::size_t n = model.accessors[node.instances.front().second].count;
  for (const auto& [name, accessor] : node.instances) n = std::min(n, model.accessors[accessor].count);
  return n;
}

/// A vector of an instance. \return whether the instances have one of that name
template <std::size_t n>
void read_vector(const Model& model, const Node& node, const char* name, std::size_t instance,
                 std::array<double, n>& vector) {
  const auto found = std::find_if(node.instances.begin(), node.instances.end(),
                                  [&](const auto& attribute) { return attribute.first == name; });
  if (found != node.instances.end()) Elements(model.accessors[found->second]).read(instance, vector);
}

/// The matrix of each node, to the scene's coordinates.
std::vector<Eigen::Matrix4d> world_matrices(const Model& model) {
  std::vector<Eigen::Matrix4d> matrices(model.nodes.size());
  std::vector<bool> is_known(model.nodes.size());
  std::vector<std::size_t> path;  // up to a node that is known, or has no parent
  for (std::size_t start = 0; start < model.nodes.size(); ++start) {
    std::optional<std::size_t> node = start;
    for (; node && !is_known[*node]; node = model.nodes[*node].parent) path.push_back(*node);
    for (; !path.empty(); path.pop_back()) {
      const Node& next = model.nodes[path.back()];
      matrices[path.back()] = next.parent ? matrices[*next.parent] * next.matrix : next.matrix;
      is_known[path.back()] = true;
    }
  }
  return matrices;
}

}  // namespace

std::size_t n_instances(const Model& model, std::size_t mesh) {
  std::size_t n = 0;
  for (const Node& node : model.nodes) {
    if (node.mesh == mesh) n += n_instances(model, node);
  }
  return n;
}

std::vector<Eigen::Matrix4d> world_transforms(const Model& model, std::size_t mesh) {
  std::vector<Eigen::Matrix4d> transforms;
  const std::vector<Eigen::Matrix4d> matrices = world_matrices(model);
  for (std::size_t number = 0; number < model.nodes.size(); ++number) {
    const Node& node = model.nodes[number];
    if (node.mesh != mesh) continue;
    const Eigen::Matrix4d& matrix = matrices[number];
    if (node.instances.empty()) transforms.push_back(matrix);
    for (std::size_t i = 0; !node.instances.empty() && i < n_instances(model, node); ++i) {
      std::array<double, 3> translation{0, 0, 0};
      std::array<double, 4> rotation{0, 0, 0, 1};
      std::array<double, 3> scale{1, 1, 1};
      read_vector(model, node, "TRANSLATION", i, translation);
      read_vector(model, node, "ROTATION", i, rotation);
      read_vector(model, node, "SCALE", i, scale);
      transforms.push_back(matrix * composed_matrix(translation, rotation, scale));
    }
  }
  return transforms;
}

}  // namespace whittle::gltf
