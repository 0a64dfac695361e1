#pragma once

#include <cstddef>
#include <vector>

namespace whittle::render {

/// A number for each pixel of a picture, rows from the top.
struct Plane {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<float> values;

  Plane(std::size_t columns, std::size_t rows) : width(columns), height(rows), values(columns * rows) {}
};

/// The weights of neighbours along a row or column: from -r to r, 2r + 1 of them.
using Kernel = std::vector<float>;

/// Sums of neighbours by weight: `along_rows` within a row, `along_columns` within a column. Pixels outside are like
/// the nearest one of the border.
Plane filtered(const Plane& plane, const Kernel& along_rows, const Kernel& along_columns);

}  // namespace whittle::render
