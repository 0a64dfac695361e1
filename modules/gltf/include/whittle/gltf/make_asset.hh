#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf {

/// An image that a new asset contains, or names.
struct NewImage {
  std::filesystem::path file{};  ///< relative to the asset's folder
  std::string bytes{};           ///< of a PNG or JPEG file, to be part of the asset; empty: the asset names `file`
};

/// A surface without metal, as rough as can be.
struct NewMaterial {
  std::string name{};
  Color color{1, 1, 1, 1};             ///< linear; below 1 in the last component it is blended with what lies behind
  std::optional<std::size_t> image{};  ///< of `NewAsset::images`; multiplies the colour
};

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
  std::vector<NewMaterial> materials{};  ///< one a group, or one if the mesh has no groups
  std::vector<NewImage> images{};
};

/// Makes an asset of a mesh: a scene with one node. Colours have 16 bits, all else is float32.
/// \throw std::range_error for a position that float32 can't hold; std::invalid_argument as `Asset::add_levels`
Asset make_asset(NewAsset asset);

/// Whether bytes begin as a PNG or JPEG file does: glTF takes no other images.
bool is_image(std::string_view bytes);

}  // namespace whittle::gltf
