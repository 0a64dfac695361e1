#pragma once

#include <cstddef>
#include <vector>

#include "whittle/render/picture.hh"

namespace whittle::render {

/// The background's light: linear.
float background_light();

/// A picture out of samples: the mean light of each pixel, encoded as sRGB and rounded to 8 bits.
/// \param samples 4 · (size · grid)², rows from the bottom: linear red, green, blue, and coverage
/// \param grid samples along a side of a pixel
Picture resolve(const std::vector<float>& samples, std::size_t size, std::size_t grid);

}  // namespace whittle::render
