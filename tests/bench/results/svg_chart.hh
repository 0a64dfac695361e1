#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace whittle::bench {

struct ChartPoint {
  double x;
  double y;
  std::string name;  ///< shown under the mouse
  std::string line;  ///< points of one series with the same word here are joined, by ascending x; empty: none
};

struct ChartSeries {
  std::string name;
  std::vector<ChartPoint> points;
};

/// Both axes logarithmic.
struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartSeries> series;
};

/// As an SVG file, readable on white and on black. Points that aren't above 0 are left out, and so are series without
/// points; a chart without any isn't written.
/// \return whether it was
/// \throw std::runtime_error if the file can't be written
bool write_svg(const std::filesystem::path& path, const Chart& chart);

}  // namespace whittle::bench
