#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/image.hh"
#include "whittle/core/material/material.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf {

/// What all materials of a new asset have in common, beside their base colours (glTF 2.0, section 3.9).
struct Shading {
  double metalness = 0;   ///< [0, 1]
  double roughness = 1;   ///< [0, 1]
  bool is_unlit = false;  ///< KHR_materials_unlit
  /// Normals in tangent space, at TEXCOORD_0; or null. They are embedded.
  std::shared_ptr<const Image> normal_map{};
};

struct NewAsset {
  std::string name{};  ///< of mesh and node
  /// A primitive per group. Zero normals get the direction of the faces. Of `attributes` texture coordinates are
  /// written, as TEXCOORD_0, TEXCOORD_1 and so on, with their first two components unchanged, and the first tangents.
  IndexedMesh mesh{};
  /// Translation of the node. Positions are relative to it, so that 32 bits also hold positions far from the origin.
  /// Default: `float32_origin` of the mesh.
  std::optional<Vec3> translation{};
  /// Coarser levels, with the same groups and attributes, and their shares of the screen (`MeshLevels`).
  std::vector<IndexedMesh> coarser{};
  std::vector<double> screen_coverage{};
  /// One per group, or one if the mesh has no groups. Written are name, base colour, image (PNG or JPEG),
  /// double-sidedness and blending, which is also on if the mesh has transparent colours.
  std::vector<Material> materials{};
  Shading shading{};
  /// Whether to embed images in the asset. Otherwise it names image files in its folder, or below it.
  bool embeds_images = true;
};

/// Makes an asset of a mesh: a scene with one node. Colours have 16 bits, other attributes are float32.
/// \throw std::range_error for a position that float32 can't hold; std::invalid_argument as `Asset::add_levels`
Asset make_asset(NewAsset asset);

}  // namespace whittle::gltf
