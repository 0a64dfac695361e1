#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace whittle::render {

/// Red, green, blue.
using Rgb = std::array<float, 3>;

/// A picture with colours encoded as sRGB, as in files and on screens.
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Rgb> pixels;  ///< width · height, rows from the top; sRGB, each in [0, 1].

  /// Share of each pixel that shows the model, in [0, 1]; as long as `pixels`, or empty: 1 in all pixels.
  std::vector<float> coverage;
};

/// Joins pictures side by side, without a gap, from left to right. \throw std::invalid_argument if heights differ
Picture side_by_side(const std::vector<Picture>& pictures);

/// The bytes of a PNG file with 8 bits a channel, lossless for pictures from `draw`. Coverage isn't stored.
/// \throw std::invalid_argument if the picture has no pixels \throw std::runtime_error if encoding fails
std::string write_png(const Picture& picture);

}  // namespace whittle::render
