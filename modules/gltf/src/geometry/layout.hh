#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/surface.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

// Where the attributes of primitives are in an `IndexedMesh`, in both directions.

namespace whittle::gltf {

/// The attribute that all sets of joints and weights are in.
inline constexpr std::string_view joints_and_weights = "JOINTS_0+WEIGHTS_0";
inline constexpr std::size_t joints_a_set = 4;

/// Components of one of `IndexedMesh::attributes`.
struct Place {
  std::string attribute;  ///< its name
  std::size_t first = 0;  ///< component
  std::size_t n = 0;
};

/// The numbers from 0 on for which a primitive has both JOINTS_n and WEIGHTS_n.
std::size_t n_joint_sets(const Primitive& primitive);
/// The most that a primitive of the mesh has.
std::size_t n_joint_sets(const Mesh& mesh);

/// Where a channel of a primitive is; not for POSITION, NORMAL and COLOR_0. \param n_sets of joints in the mesh
Place place_of(const Model& model, const Channel& channel, const Primitive& primitive, std::size_t n_sets);

/// Whether a channel is in an array of its own.
bool has_own_array(std::string_view channel);

/// All of a mesh, without values, in the order of the first primitives that have them.
std::vector<Attribute> attributes_of(const Model& model, const Mesh& mesh);

}  // namespace whittle::gltf
