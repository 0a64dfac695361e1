#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "document/json.hh"
#include "encode/encode.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"
#include "write/new_geometry.hh"

// Positions as integers (KHR_mesh_quantization): multiples of a step, counted from an origin. Step and origin stand in
// a new node between a mesh and its node, or in the inverse bind matrices of its skin.

namespace whittle::gltf {

struct Quantization {
  std::map<std::size_t, Grid> of_mesh;  ///< by number
  std::map<std::size_t, Grid> of_skin;  ///< those of its meshes, which are equal
  /// Why the positions of other replaced meshes stay real numbers, by number.
  std::map<std::size_t, std::string> kept;
};

/// Meshes that share a skin get one grid.
Quantization quantization_of(const Json& document, const Model& model, const Replacements& replacements);

/// Removes the inverse bind matrices that `quantized_skins` replaces.
void strip_skins(Json& document, const Quantization& quantization);

/// The inverse bind matrices of skins, for meshes with their grids.
std::vector<NewAccessor> quantized_skins(const Json& document, const Model& model, const Quantization& quantization);

/// Gives each node without a skin that uses a mesh with a grid a child, which moves and scales the mesh.
void place_grids(Json& document, const Quantization& quantization);

}  // namespace whittle::gltf
