#pragma once

#include <string>
#include <vector>

namespace whittle::app {

/// A bar for each category.
struct BarSeries {
  std::string name;
  std::vector<double> shares;  ///< in [0, 1], a category each
};

/// How several series are distributed over the same categories.
struct BarChart {
  std::string title;
  std::string x_label;
  std::vector<std::string> categories;  ///< a label each; empty ones are not drawn
  std::vector<BarSeries> series;
};

/// A drawing in SVG, readable on white and on black. \return empty for a chart without series or categories
std::string to_svg(const BarChart& chart);

}  // namespace whittle::app
