#pragma once

#include <string>
#include <vector>

namespace whittle::app {

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

/// A drawing in SVG, readable on white and on black. Points with a value of 0 or below are left out, and so are series
/// without points. \return empty for a chart without series
std::string to_svg(const Chart& chart);

}  // namespace whittle::app
