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

/// Gives each node that uses a mesh coarser levels of detail: nodes that differ from it in their mesh alone, and that
/// animations move as they move it. Viewers show a level in place of the node and of all below it. So a node that has
/// more than a mesh (children, a camera, a light) passes the mesh on to a child of its own first.
/// \param coarser the meshes of the levels, the finer ones first
/// \param coverage the least share of the screen that each level is shown at, that of the node first
/// \pre no such node has levels
void add_level_nodes(Json& document, std::size_t mesh, std::span<const std::size_t> coarser,
                     std::span<const double> coverage);

}  // namespace whittle::gltf
