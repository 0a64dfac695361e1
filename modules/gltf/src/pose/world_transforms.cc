#include "pose/world_transforms.hh"

#include "geometry/instances.hh"
#include "geometry/layout.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf {
namespace {

/// A file may be simplified although nobody can pose its skins.
std::optional<Rig> rig_if_right(const Model& model, const Part& root) {
  try {
    return read_rig(model, root);
  } catch (const io::ReadError&) {
    return std::nullopt;
  }
}

/// Null if it has none, or one without joints.
const Skin* skin_of(const Rest& rest, std::size_t node) {
  if (!rest.rig || !rest.rig->skin_of_node[node]) return nullptr;
  const Skin& skin = rest.rig->skins[*rest.rig->skin_of_node[node]];
  return skin.joints.empty() ? nullptr : &skin;
}

}  // namespace

Rest read_rest(const Model& model, const Part& root) {
  return {world_matrices(model, local_matrices(model)), rig_if_right(model, root)};
}

std::vector<Eigen::Matrix4d> world_transforms(const Model& model, const Rest& rest, std::size_t mesh) {
  std::vector<Eigen::Matrix4d> transforms;
  const bool has_joints = n_joint_sets(model.meshes[mesh]) > 0;
  for (std::size_t number = 0; number < model.nodes.size(); ++number) {
    const Node& node = model.nodes[number];
    if (node.mesh != mesh || !node.is_shown) continue;
    if (const Skin* const skin = has_joints ? skin_of(rest, number) : nullptr) {
      transforms.push_back(rest.worlds[skin->joints.front()] * skin->inverse_bind.front());
      continue;
    }
    for (const Eigen::Matrix4d& instance : instance_matrices(model, node)) {
      transforms.push_back(rest.worlds[number] * instance);
    }
  }
  return transforms;
}

}  // namespace whittle::gltf
