#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/gltf/material.hh"

// How the surfaces in a mesh file look, for what shows them.

namespace whittle::app {

/// An image that materials name.
struct MaterialImage {
  std::string name;                            ///< in messages: "image 3", "texture wall.png"
  std::shared_ptr<const std::string> bytes{};  ///< of the file, of whatever format; null if it can't be read
  std::string problem{};                       ///< then: why not
};

/// Base colour · image, in linear light, as in glTF.
struct FileMaterial {
  std::array<double, 4> base_color = {1, 1, 1, 1};       ///< red, green, blue, and opacity
  std::array<double, 4> imageless_color = {1, 1, 1, 1};  ///< likewise, where the image isn't there, or can't be shown
  std::optional<std::size_t> image{};                    ///< of `FileMaterials::images`
  std::string texcoord = "TEXCOORD_0";                   ///< the attribute with the image's coordinates
  /// To coordinates that are (0, 0) at the outer corner of the image's first pixel.
  Eigen::Affine2d texcoord_transform = Eigen::Affine2d::Identity();
  std::array<gltf::Wrap, 2> wrap{};
  gltf::AlphaMode alpha_mode = gltf::AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = false;
};

struct FileMaterials {
  /// Of glTF by mesh of the file and primitive; of meshes without triangles none. Of other formats those of one mesh,
  /// by face group, or one where it has no groups.
  std::vector<std::vector<FileMaterial>> of_meshes;
  bool are_told = false;              ///< whether the file says anything of how it looks
  std::vector<MaterialImage> images;  ///< each once
  std::vector<std::string> warnings;  ///< a line each, without the name of the file: what can't be read but images
};

/// From glTF, from the material libraries of an OBJ file, or the texture that a PLY file names.
/// \throw io::ReadError for wrong materials of glTF
FileMaterials read_materials(const Scene& input);

/// What glTF says of a texture, in the words of who shows it. \tparam Wrap has the enumerators of `gltf::Wrap`
template <class Wrap>
Wrap wrap_as(gltf::Wrap wrap) {
  switch (wrap) {
    case gltf::Wrap::mirrored_repeat:
      return Wrap::mirrored_repeat;
    case gltf::Wrap::clamp_to_edge:
      return Wrap::clamp_to_edge;
    case gltf::Wrap::repeat:
      break;
  }
  return Wrap::repeat;
}

/// \tparam Alpha has the enumerators of `gltf::AlphaMode`
template <class Alpha>
Alpha alpha_as(gltf::AlphaMode mode) {
  switch (mode) {
    case gltf::AlphaMode::mask:
      return Alpha::mask;
    case gltf::AlphaMode::blend:
      return Alpha::blend;
    case gltf::AlphaMode::opaque:
      break;
  }
  return Alpha::opaque;
}

}  // namespace whittle::app
