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

Eigen::Matrix4d world_matrix(const Model& model, const Node& node) {
  Eigen::Matrix4d matrix = node.matrix;
  for (std::optional<std::size_t> parent = node.parent; parent; parent = model.nodes[*parent].parent) {
    matrix = model.nodes[*parent].matrix * matrix;
  }
  return matrix;
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
  for (const Node& node : model.nodes) {
    if (node.mesh != mesh) continue;
    const Eigen::Matrix4d matrix = world_matrix(model, node);
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
