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

/// The most pixels of a side of an image.
inline constexpr std::size_t max_image_size = 16384;

/// Decodes a PNG or JPEG file; the first bytes say which it is. Colour profiles, gamma and orientation in the file are
/// ignored, as glTF asks. 16 bits a channel become 8.
/// \throw std::runtime_error if the bytes are neither, are damaged or truncated, or a side exceeds `max_image_size`
Pixels read_image(std::string_view bytes);

}  // namespace whittle::render
