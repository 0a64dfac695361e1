#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "model/model.hh"

namespace whittle::gltf {

/// Of each node, to its parent's coordinates, as the document has it.
std::vector<Eigen::Matrix4d> local_matrices(const Model& model);
/// Of each node, to the scene's coordinates. \param locals of each node, to its parent's coordinates
std::vector<Eigen::Matrix4d> world_matrices(const Model& model, std::span<const Eigen::Matrix4d> locals);

/// From a node's mesh to the node, for each instance: the identity, but for nodes with EXT_mesh_gpu_instancing.
std::vector<Eigen::Matrix4d> instance_matrices(const Model& model, const Node& node);

/// `Asset::n_instances`.
std::size_t n_instances(const Model& model, std::size_t mesh);

}  // namespace whittle::gltf
