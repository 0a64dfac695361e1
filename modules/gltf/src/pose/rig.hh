#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "document/json.hh"
#include "model/model.hh"

namespace whittle::gltf {

/// Joints that bend a mesh.
struct Skin {
  std::vector<std::size_t> joints;            ///< nodes
  std::vector<Eigen::Matrix4d> inverse_bind;  ///< of each joint: from the mesh's coordinates to the joint's
};

/// Skins, morph targets and animations of a document.
struct Rig {
  std::vector<Skin> skins;
  std::vector<std::optional<std::size_t>> skin_of_node;  ///< below the number of skins
  std::vector<std::vector<double>> weights_of_node;      ///< of morph targets: the node's, or its mesh's
};

/// \throw io::ReadError if a skin, a joint or a matrix is missing, has the wrong type, or isn't finite
Rig read_rig(const Model& model, const Part& root);

}  // namespace whittle::gltf
