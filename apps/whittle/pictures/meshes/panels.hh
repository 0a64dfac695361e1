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

/// Pixels from the left and from the top.
struct PanelCorner {
  std::size_t left, top;
};

/// Names what is in a part of a picture. \param corner upper left corner of the part \param width for the text, pixels
void draw_label(RgbPicture& picture, const std::string& text, const PanelCorner& corner, std::size_t width);

/// A vertical line. \param x pixels from the left
void draw_divider(RgbPicture& picture, std::size_t x);

/// Says what colours mean, at the lower right corner. Nothing without rows.
void draw_legend(RgbPicture& picture, const std::vector<PanelRow>& rows);

}  // namespace whittle::app
