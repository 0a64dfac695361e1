#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "whittle/render/picture.hh"

// What colours mean, as in the page of `report` (modules/report/viewer/src/colours.js).

namespace whittle::app {

/// The colour of 0xRRGGBB.
constexpr render::Rgb rgb_of(std::uint32_t number) {
  const auto part = [number](unsigned shift) { return static_cast<float>(number >> shift & 0xFFU) / 255; };
  return {part(16), part(8), part(0)};
}

/// A row of colours.
struct ColorScale {
  std::vector<render::Rgb> colors;
  std::vector<std::string> names;  ///< of the colours; or empty: of an even scale
};

/// Eight steps of viridis.
const ColorScale& error_scale();
/// Eight steps of cividis.
const ColorScale& shape_scale();
/// 3 or less, 4, … 9 or more edges at a vertex; 6 is grey.
const ColorScale& valence_scale();

}  // namespace whittle::app
