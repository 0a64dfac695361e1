#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "model/model.hh"

namespace whittle::gltf {

/// `Asset::n_instances`.
std::size_t n_instances(const Model& model, std::size_t mesh);
/// `Asset::world_transforms`.
std::vector<Eigen::Matrix4d> world_transforms(const Model& model, std::size_t mesh);

}  // namespace whittle::gltf
