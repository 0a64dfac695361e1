#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "document/json.hh"

// Levels of detail in a document: MSFT_lod of nodes
// (https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Vendor/MSFT_lod).

namespace whittle::gltf {

/// Whether a node that uses a mesh has levels of detail, or is one.
bool has_levels(const Json& document, std::size_t mesh);

/// Adds a mesh with the primitives, the weights and the extensions of another one. \return its number
std::size_t add_mesh_copy(Json& document, std::size_t mesh, std::size_t level);

/// Gives each node that uses a mesh coarser levels of detail: nodes that differ only in their mesh, moved by the same
/// animations. Viewers show a level in place of the node and its descendants. So a node with more than a mesh
/// (children, a camera, a light) first passes the mesh on to a new child.
/// \param coarser the meshes of the levels, finest first
/// \param coverage the least share of the screen at which each level is shown, first of the node
/// \pre no such node has levels
void add_level_nodes(Json& document, std::size_t mesh, std::span<const std::size_t> coarser,
                     std::span<const double> coverage);

}  // namespace whittle::gltf
