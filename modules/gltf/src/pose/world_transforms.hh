#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "document/json.hh"
#include "model/model.hh"
#include "pose/rig.hh"

namespace whittle::gltf {

/// Where the nodes of an asset are when nothing moves.
struct Rest {
  std::vector<Eigen::Matrix4d> worlds;  ///< of each node, to the scene's coordinates
  std::optional<Rig> rig;               ///< none if something of a skin is wrong
};

Rest read_rest(const Model& model, const Part& root);

/// `Asset::world_transforms`.
std::vector<Eigen::Matrix4d> world_transforms(const Model& model, const Rest& rest, std::size_t mesh);

}  // namespace whittle::gltf
