#pragma once

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace whittle::app {

/// The colours of a chart's series, for the colour-blind, too.
const char* colour_of(std::size_t series);

/// \param format printf format for a double
std::string formatted(const char* format, double value);

/// Collects the elements of a drawing as text. Lengths are pixels, with one decimal.
class SvgDrawing {
 public:
  SvgDrawing(double width, double height);

  /// \param anchor "start", "middle" or "end" \param attributes further ones
  void add_text(double x, double y, const char* anchor, const std::string& text, const std::string& attributes = {});
  void add_grid_line(double x0, double y0, double x1, double y1);
  void add_path(const std::vector<std::array<double, 2>>& points, const char* colour);
  /// A square, a diamond, a triangle, or an inverted triangle. \param title tooltip
  void add_marker(double x, double y, std::size_t series, const std::string& title);
  /// \param title tooltip
  void add_bar(double x, double y, double width, double height, std::size_t series, const std::string& title);
  std::string finished() const { return out_.str() + "</svg>\n"; }

 private:
  std::ostringstream out_;
};

}  // namespace whittle::app
