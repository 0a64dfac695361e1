#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace whittle::gltf {

/// What a texture shows outside of [0, 1].
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// An image of an asset, as a material uses it.
struct TextureUse {
  std::size_t image = 0;  ///< Its number in the document.
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  std::size_t texcoord = 0;  ///< n of TEXCOORD_n.
  /// From the vertices' coordinates to the image's (KHR_texture_transform). (0, 0) is the image's upper left corner.
  Eigen::Affine2d transform = Eigen::Affine2d::Identity();
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// The colour of a surface without light, and how far it is transparent.
struct Material {
  std::array<double, 4> base_color = {1, 1, 1, 1};  ///< Linear red, green, blue, and opacity; each in [0, 1].
  std::optional<TextureUse> base_color_texture;     ///< Its values are multiplied by `base_color`.
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;  ///< Not negative. For `mask`: the least opacity that is drawn.
  bool double_sided = false;
};

}  // namespace whittle::gltf
