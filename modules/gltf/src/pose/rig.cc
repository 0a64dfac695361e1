#include "pose/rig.hh"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "geometry/elements.hh"

namespace whittle::gltf {
namespace {

std::vector<Eigen::Matrix4d> read_inverse_bind(const Model& model, const Part& part, std::size_t n_joints) {
  const auto number = part.index("inverseBindMatrices", model.accessors.size(), "accessor");
  if (!number) return std::vector<Eigen::Matrix4d>(n_joints, Eigen::Matrix4d::Identity());
  const Elements elements(model.accessors[*number]);
  if (elements.shape() != ElementShape{4, 4}) part.fail("its inverse bind matrices are " + name_of(elements.shape()));
  if (elements.size() < n_joints) {
    part.fail("it has " + std::to_string(elements.size()) + " inverse bind matrices for " + std::to_string(n_joints) +
              " joints");
  }
  std::vector<Eigen::Matrix4d> matrices(n_joints);
  for (std::size_t j = 0; j < n_joints; ++j) {
    std::array<double, 16> columns{};
    elements.read(j, columns);
    matrices[j] = Eigen::Map<const Eigen::Matrix4d>(columns.data());
    if (!matrices[j].allFinite()) part.fail("inverse bind matrix " + std::to_string(j) + " is not finite");
  }
  return matrices;
}

Skin read_skin(const Model& model, const Part& part) {
  Skin skin;
  skin.joints = part.indices("joints", model.nodes.size(), "node");
  skin.inverse_bind = read_inverse_bind(model, part, skin.joints.size());
  return skin;
}

}  // namespace

Rig read_rig(const Model& model, const Part& root) {
  Rig rig;
  for (const Part& part : root.array("skins", "skin")) rig.skins.push_back(read_skin(model, part));
  std::vector<std::vector<double>> weights_of_mesh;
  for (const Part& part : root.array("meshes", "mesh")) {
    weights_of_mesh.push_back(part.numbers("weights").value_or(std::vector<double>{}));
  }
  for (const Part& part : root.array("nodes", "node")) {
    const std::optional<std::size_t> mesh = model.nodes[rig.skin_of_node.size()].mesh;
    rig.skin_of_node.push_back(part.index("skin", rig.skins.size(), "skin"));
    std::vector<double> weights = part.numbers("weights").value_or(std::vector<double>{});
    if (weights.empty() && mesh) weights = weights_of_mesh[*mesh];
    rig.weights_of_node.push_back(std::move(weights));
  }
  return rig;
}

}  // namespace whittle::gltf
