#pragma once

#include <cmath>
#include <cstdint>

// The curve of sRGB, IEC 61966-2-1.

namespace whittle::render {

/// Light of an sRGB value. Both in [0, 1].
template <class Real>
Real linear_of_srgb(Real value) {
  return value <= Real(0.04045) ? value / Real(12.92) : std::pow((value + Real(0.055)) / Real(1.055), Real(2.4));
}

/// The nearest of the 256 sRGB values. Light below 0 gives 0, above 1 gives 255. Takes a table, no power.
std::uint8_t srgb8_of_linear(float light);

/// The nearest of 256 values: [0, 1] to 0 … 255, clamped.
inline std::uint8_t to_8_bits(float value) {
  return static_cast<std::uint8_t>(value > 0 ? (value < 1 ? value * 255 + 0.5F : 255.0F) : 0.0F);
}

}  // namespace whittle::render
