#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/render/picture.hh"

namespace whittle::render {

/// The background's light: linear.
float background_light();

/// The samples of a picture, or of a part of one.
struct SampleGrid {
  std::size_t width = 0;   ///< pixels
  std::size_t height = 0;  ///< pixels
  std::size_t side = 1;    ///< samples along a side of a pixel
};

/// What the numbers of samples mean.
enum class SampleColors : std::uint8_t { linear, srgb };

/// A picture out of samples: the mean of each pixel, encoded as sRGB and rounded to 8 bits.
/// \param samples 4 a sample, rows from the bottom: red, green, blue, and coverage
Picture resolve(const std::vector<float>& samples, const SampleGrid& grid, SampleColors colors);

}  // namespace whittle::render
