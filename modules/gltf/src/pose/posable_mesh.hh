#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "pose/rig.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// A mesh of an asset, with its data for poses.
struct PosableMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> faces;

  std::size_t n_influences = 0;  ///< a vertex has
  std::vector<Index> joints;     ///< `n_influences` a vertex; 0 where the weight is 0
  std::vector<double> weights;   ///< per vertex and joint; not negative, with sum 1 or 0 per vertex
  std::size_t n_joints = 0;      ///< more than the largest joint

  std::vector<std::vector<Vec3>> displacements;  ///< of each morph target, of each vertex; empty: of none
};

/// \param mesh from `Asset::triangles`.
/// \param what "mesh 0"
/// \param file for messages
/// \throw io::ReadError if a joint is no whole number from 0 on
PosableMesh posable_mesh(IndexedMesh mesh, const std::string& what, const std::string& file);

/// Positions with morph targets. \param weights of the targets; absent ones are 0
std::vector<Vec3> apply_targets(const PosableMesh& mesh, std::span<const double> weights);

/// Moves positions by a matrix whose last row is 0, 0, 0, 1.
void apply_matrix(std::span<Vec3> positions, const Eigen::Matrix4d& matrix);

/// Moves positions by their joints.
/// \param joints per joint, from the mesh's coordinates to the scene's
/// \param matrix for vertices without a weight
void apply_skin(const PosableMesh& mesh, std::span<const Eigen::Matrix4d> joints, const Eigen::Matrix4d& matrix,
                std::span<Vec3> positions);

}  // namespace whittle::gltf
