#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace whittle::render {

/// A decoded image.
struct Pixels {
  std::size_t width = 0;
  std::size_t height = 0;
  /// 4 · width · height; rows from the top: red, green, blue, sRGB-encoded, and opacity.
  std::vector<std::uint8_t> rgba;
};

/// Largest number of pixels along a side of an image.
inline constexpr std::size_t max_image_size = 16384;

/// Decodes a PNG or JPEG file, recognised by its first bytes. Colour profiles, gamma and orientation in the file are
/// ignored, as glTF requires. 16 bits a channel become 8.
/// \throw std::runtime_error for other, damaged or truncated files, or if a side exceeds `max_image_size`
Pixels read_image(std::string_view bytes);

}  // namespace whittle::render
