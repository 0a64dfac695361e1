#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "model/model.hh"

namespace whittle::gltf {

/// Per node, the document's matrix to its parent's coordinates.
std::vector<Eigen::Matrix4d> local_matrices(const Model& model);
/// Per node, the matrix to the scene's coordinates. \param locals per node, to its parent's coordinates
std::vector<Eigen::Matrix4d> world_matrices(const Model& model, std::span<const Eigen::Matrix4d> locals);

/// Per instance, the matrix from a node's mesh to the node: the identity without EXT_mesh_gpu_instancing.
std::vector<Eigen::Matrix4d> instance_matrices(const Model& model, const Node& node);

/// `Asset::n_instances`.
std::size_t n_instances(const Model& model, std::size_t mesh);

}  // namespace whittle::gltf
