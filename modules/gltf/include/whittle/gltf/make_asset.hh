#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf {

struct NewAsset {
  std::string name{};  ///< of mesh and node
  /// A primitive each group. Normals without a direction get that of the faces. Of `attributes` only texture
  /// coordinates are written, as TEXCOORD_0, TEXCOORD_1 and so on, their first two components as they are.
  IndexedMesh mesh{};
  /// Where the node stands. Positions count from there, so that 32 bits hold those far from the origin, too.
  /// Default: `float32_origin` of the mesh.
  std::optional<Vec3> translation{};
  /// Coarser levels of it, with the same groups and attributes, and the shares of the screen, as `MeshLevels` has them.
  std::vector<IndexedMesh> coarser{};
  std::vector<double> screen_coverage{};
  /// One a group, or one if the mesh has no groups. Written are name, base colour, its image, which must be PNG or
  /// JPEG, whether both sides are seen, and whether it blends, which it does wherever the mesh has transparent colours.
  /// No metal, as rough as can be.
  std::vector<Material> materials{};
  /// Whether images become part of the asset. Otherwise it names the files of those in its folder, or below it.
  bool embeds_images = true;
};

/// Makes an asset of a mesh: a scene with one node. Colours have 16 bits, all else is float32.
/// \throw std::range_error for a position that float32 can't hold; std::invalid_argument as `Asset::add_levels`
Asset make_asset(NewAsset asset);

}  // namespace whittle::gltf
