#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace whittle::render {

/// What a texture shows outside of [0, 1].
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge };

/// An image that is put on a surface. Texture coordinate (0, 0) is the outer corner of the first pixel, as in glTF. For
/// formats that count from below, such as OBJ, see `Material::texcoord_transform`.
struct Texture {
  std::size_t width = 0;
  std::size_t height = 0;
  /// 4 · width · height; rows from the top: red, green, blue, sRGB-encoded, and opacity.
  std::vector<std::uint8_t> rgba;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
};

/// The most pixels of a side of a texture.
inline constexpr std::size_t max_texture_size = 16384;

/// Decodes a PNG or JPEG file; the first bytes say which it is. Colour profiles, gamma and orientation in the file are
/// ignored, as glTF asks. 16 bits a channel become 8.
/// \throw std::runtime_error if the bytes are neither, are damaged or truncated, or a side exceeds `max_texture_size`
Texture read_image(std::string_view bytes);

}  // namespace whittle::render
