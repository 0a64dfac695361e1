#pragma once

#include "document/json.hh"
#include "model/model.hh"
#include "write/output.hh"

namespace whittle::gltf {

/// Makes one primitive of those with the same material and the same attributes: of the primitives of each mesh, and of
/// meshes that stand still in a scene (`WriteOptions::merge`). The first mesh gets the triangles of the others.
/// \return all meshes; those that have lost all faces are empty
Replacements merged(const Json& document, const Model& model, Replacements replacements);

/// Removes the meshes that `merged` has emptied. Numbers of the others change.
void drop_empty_meshes(Json& document, const Replacements& replacements);

}  // namespace whittle::gltf
