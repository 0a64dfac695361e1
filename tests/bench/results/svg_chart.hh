#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace whittle::bench {

struct ChartPoint {
  double x;
  double y;
  std::string name;  ///< tooltip
  std::string line;  ///< points of one series with the same word here are joined in order of x; empty: not joined
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

/// Writes an SVG file, readable on white and on black. Points with a value of 0 or below are left out, and so are
/// series without points. A chart without series isn't written.
/// \return whether the file was written
/// \throw std::runtime_error if the file can't be written
bool write_svg(const std::filesystem::path& path, const Chart& chart);

}  // namespace whittle::bench
