#include <algorithm>
#include <cmath>

#include "whittle/render/picture_error.hh"

namespace whittle::render {

namespace {

/// Evenly spaced; lightness grows evenly, as in matplotlib's magma.
constexpr std::array<Rgb, 5> error_colors = {
    {{0, 0, 0.02F}, {0.32F, 0.07F, 0.49F}, {0.72F, 0.22F, 0.47F}, {0.99F, 0.54F, 0.38F}, {0.99F, 0.99F, 0.75F}}};

Rgb color_of_error(float error) {
  const float place = std::clamp(error, 0.0F, 1.0F) * (error_colors.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), error_colors.size() - 2);
  Rgb color{};
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = std::lerp(error_colors[i][k], error_colors[i + 1][k], place - static_cast<float>(i));
  return color;
}

}  // namespace

Picture picture_of(const ErrorMap& map) {
  Picture picture{map.width, map.height, {}, {}};
  picture.pixels.reserve(map.values.size());
  for (const float value : map.values) picture.pixels.push_back(color_of_error(value));
  return picture;
}

}  // namespace whittle::render
