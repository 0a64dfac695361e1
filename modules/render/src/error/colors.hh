#pragma once

#include <array>

// Colour spaces of FLIP. White is that of sRGB, D65.

namespace whittle::render {

using Triple = std::array<float, 3>;

/// Linear light of sRGB's primaries to opponent colours: achromatic, red-green, blue-yellow.
Triple opponent_of_linear(const Triple& rgb);
Triple linear_of_opponent(const Triple& opponent);

/// Relative luminance, [0, 1], of an achromatic opponent value.
float luminance_of_achromatic(float achromatic);

/// Linear light to CIELAB, both chromatic numbers times lightness/100: Hunt's effect.
Triple hunt_lab_of_linear(const Triple& rgb);

/// The distance HyAB of two colours of CIELAB. \cite abasi_2020_hyab
float hyab(const Triple& a, const Triple& b);

}  // namespace whittle::render
