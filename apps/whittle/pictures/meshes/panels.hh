#pragma once

#include <string>
#include <vector>

#include "pictures/draw_meshes.hh"
#include "pictures/meshes/scales.hh"

// Boxes with text that lie on a picture.

namespace whittle::app {

/// A part of a box, below the part before it.
struct PanelRow {
  std::string text;
  const ColorScale* scale = nullptr;  ///< below the text; or null
  double top = 0;                     ///< value at the end of an even scale
};

/// Names what is in a part of a picture, at its upper left corner.
/// \param left, width of the part, pixels
void draw_label(RgbPicture& picture, const std::string& text, std::size_t left, std::size_t width);

/// Says what colours mean, at the lower right corner. Nothing without rows.
void draw_legend(RgbPicture& picture, const std::vector<PanelRow>& rows);

}  // namespace whittle::app
