#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "whittle/core/material/image.hh"

// Unlit materials in terms of glTF 2.0 (sections 3.8 and 3.9): base colour factor · base colour texture · vertex
// colour, in linear light.

namespace whittle {

/// Repetition of a texture outside of [0, 1].
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// An image on a surface. Its red, green and blue are sRGB-encoded, its opacity isn't.
struct Texture {
  std::shared_ptr<const Image> image{};  ///< Not null. Textures that have an image in common share it.
  /// The attribute with the texture's coordinates. A mesh without it is shown without the texture.
  std::string texcoord = "TEXCOORD_0";
  /// Maps the attribute's coordinates to image coordinates, as in KHR_texture_transform: (0, 0) is the outer corner of
  /// the first pixel, rows go down. For OBJ and PLY: (u, v) to (u, 1 - v).
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
  std::array<Wrap, 2> wrap{};  ///< Along the first and the second coordinate.
  /// Whether `Material::base_color` multiplies the texture, as in glTF. If not, its red, green and blue are a fallback
  /// for a missing texture: most programs read MTL's Kd this way.
  bool is_tinted = true;
};

/// Use of a colour's opacity.
enum class Alpha : std::uint8_t {
  opaque,  ///< Ignored.
  mask,    ///< Below the cutoff nothing is drawn; from it on, the surface is opaque.
  blend    ///< Blended with the background.
};

struct Material {
  std::string name{};                               ///< As in `IndexedMesh::group_names`. Empty: no name.
  std::array<double, 4> base_color = {1, 1, 1, 1};  ///< Linear red, green, blue, and opacity; each in [0, 1].
  std::optional<Texture> base_color_texture{};
  Alpha alpha_mode = Alpha::opaque;
  double alpha_cutoff = 0.5;  ///< [0, inf), for `Alpha::mask`.
  bool double_sided = false;  ///< Otherwise back faces are not drawn.
};

/// Factor on texture and vertex colour: `base_color`, or white with its opacity if the texture isn't tinted.
/// \param material without its texture if that can't be shown
std::array<double, 4> base_color_factor(const Material& material);

/// Encoding of vertex colours.
enum class ColorEncoding : std::uint8_t {
  linear,  ///< As in glTF.
  srgb     ///< As in most other files.
};

}  // namespace whittle
