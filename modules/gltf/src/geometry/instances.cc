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

/// Reads a vector of an instance. It stays as it is if the instances have none of that name.
template <std::size_t n>
void read_vector(const Model& model, const Node& node, const char* name, std::size_t instance,
                 std::array<double, n>& vector) {
  const auto found = std::find_if(node.instances.begin(), node.instances.end(),
                                  [&](const auto& attribute) { return attribute.first == name; });
  if (found != node.instances.end()) Elements(model.accessors[found->second]).read(instance, vector);
}

}  // namespace

std::vector<Eigen::Matrix4d> local_matrices(const Model& model) {
  std::vector<Eigen::Matrix4d> matrices;
  matrices.reserve(model.nodes.size());
  for (const Node& node : model.nodes) matrices.push_back(node.matrix);
  return matrices;
}

std::vector<Eigen::Matrix4d> world_matrices(const Model& model, std::span<const Eigen::Matrix4d> locals) {
  std::vector<Eigen::Matrix4d> matrices(model.nodes.size());
  std::vector<bool> is_known(model.nodes.size());
  std::vector<std::size_t> path;  // up to a node that is known, or has no parent
  for (std::size_t start = 0; start < model.nodes.size(); ++start) {
    std::optional<std::size_t> node = start;
    for (; node && !is_known[*node]; node = model.nodes[*node].parent) path.push_back(*node);
    for (; !path.empty(); path.pop_back()) {
      const std::optional<std::size_t> parent = model.nodes[path.back()].parent;
      matrices[path.back()] = parent ? matrices[*parent] * locals[path.back()] : locals[path.back()];
      is_known[path.back()] = true;
    }
  }
  return matrices;
}

std::vector<Eigen::Matrix4d> instance_matrices(const Model& model, const Node& node) {
  if (node.instances.empty()) return {Eigen::Matrix4d::Identity()};
  std::vector<Eigen::Matrix4d> matrices;
  for (std::size_t i = 0; i < n_instances(model, node); ++i) {
    Transform transform;
    read_vector(model, node, "TRANSLATION", i, transform.translation);
    read_vector(model, node, "ROTATION", i, transform.rotation);
    read_vector(model, node, "SCALE", i, transform.scale);
    matrices.push_back(transform.matrix());
  }
  return matrices;
}

std::size_t n_instances(const Model& model, std::size_t mesh) {
  std::size_t n = 0;
  for (const Node& node : model.nodes) {
    if (node.mesh == mesh && node.is_shown) n += n_instances(model, node);
  }
  return n;
}

}  // namespace whittle::gltf
