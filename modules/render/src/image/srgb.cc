#include "whittle/render/srgb.hh"

#include <algorithm>
#include <array>
#include <cstddef>

namespace whittle::render {

namespace {

/// Element i: the light half-way, on the scale of sRGB, between values i and i + 1.
std::array<float, 255> lights_between_values() {
  std::array<float, 255> lights{};
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i] = static_cast<float>(linear_of_srgb((static_cast<double>(i) + 0.5) / 255));
  }
  return lights;
}

constexpr std::size_t n_steps = 1024;

/// The nearest value of the light where each of `n_steps` steps begins.
std::array<std::uint8_t, n_steps> values_at_steps(const std::array<float, 255>& between) {
  std::array<std::uint8_t, n_steps> values{};
  for (std::size_t i = 0; i < n_steps; ++i) {
    const float light = static_cast<float>(i) / n_steps;
    values[i] = static_cast<std::uint8_t>(std::upper_bound(between.begin(), between.end(), light) - between.begin());
  }
  return values;
}

}  // namespace

std::uint8_t srgb8_of_linear(float light) {
  static const std::array<float, 255> between = lights_between_values();
  static const std::array<std::uint8_t, n_steps> at_step = values_at_steps(between);
  if (!(light > 0)) return 0;
  if (light >= 1) return 255;
  // A step has at most four of the lights between values.
  std::uint8_t value = at_step[static_cast<std::size_t>(light * n_steps)];
  while (value < 255 && light >= between[value]) ++value;
  return value;
}

}  // namespace whittle::render
