#pragma once

#include <cstddef>
#include <functional>

#include "document/json.hh"

namespace whittle::gltf {

/// Calls `function` with the channels of an animation, and the place of one that moves a node.
void for_each_channel(Json& document, std::size_t node, const std::function<void(Json&, std::size_t)>& function);

/// Moves a node's mesh into a new child, with its skin, its weights and its instances. \return the child's number
std::size_t pass_mesh_on(Json& document, std::size_t number);

}  // namespace whittle::gltf
