#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace whittle::render {

/// Red, green, blue.
using Rgb = std::array<float, 3>;

/// A picture with colours as files and screens have them: encoded as sRGB, not linear.
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Rgb> pixels;  ///< width · height, rows from the top; sRGB, each in [0, 1].

  /// The share of each pixel that shows the model, in [0, 1]; as long as `pixels`, or empty: all of all pixels.
  std::vector<float> coverage;
};

/// Pictures side by side, without a gap, from left to right. \throw std::invalid_argument if heights differ
Picture side_by_side(const std::vector<Picture>& pictures);

/// The bytes of a PNG file with 8 bits a channel. Pictures that `draw` made lose nothing. Coverage isn't stored.
/// \throw std::invalid_argument if the picture has no pixels \throw std::runtime_error if it can't be stored
std::string write_png(const Picture& picture);

}  // namespace whittle::render
