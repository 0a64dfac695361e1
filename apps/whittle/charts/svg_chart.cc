#include "charts/svg_chart.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "charts/svg_drawing.hh"

namespace whittle::app {
namespace {

// Pixels.
constexpr double line_chart_width = 920;
constexpr double line_chart_height = 520;
constexpr double chart_left = 80;
constexpr double chart_right = 690;  // the legend is to the right of it
constexpr double chart_top = 50;
constexpr double chart_bottom = 460;
constexpr double legend_step = 22;

/// 1, 2 and 5 times powers of ten, from the last one at or below `low` to the first one at or above `high`.
std::vector<double> ticks_around(double low, double high) {
  constexpr double rounding = 1e-9;
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(low))); true; ++power) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = step * std::pow(10, power);
      if (value <= low * (1 + rounding)) ticks.clear();
      ticks.push_back(value);
      if (value >= high * (1 - rounding) && ticks.size() > 1) return ticks;
    }
  }
}

/// Maps values to pixels on a logarithmic scale.
struct Axis {
  std::vector<double> ticks;
  double begin;  ///< pixel of the first tick
  double end;    ///< pixel of the last one

  double at(double value) const {
    return begin + (end - begin) * std::log(value / ticks.front()) / std::log(ticks.back() / ticks.front());
  }
};

void draw_axes(SvgDrawing& drawing, const Chart& chart, const Axis& x, const Axis& y) {
  for (const double tick : x.ticks) {
    drawing.add_grid_line(x.at(tick), chart_top, x.at(tick), chart_bottom);
    drawing.add_text(x.at(tick), chart_bottom + 18, "middle", formatted("%.7g", tick));
  }
  for (const double tick : y.ticks) {
    drawing.add_grid_line(chart_left, y.at(tick), chart_right, y.at(tick));
    drawing.add_text(chart_left - 8, y.at(tick) + 4, "end", formatted("%.4g", tick));
  }
  drawing.add_text((chart_left + chart_right) / 2, chart_bottom + 44, "middle", chart.x_label);
  drawing.add_text(-(chart_top + chart_bottom) / 2, 18, "middle", chart.y_label, "transform=\"rotate(-90)\"");
  drawing.add_text(chart_left, chart_top - 20, "start", chart.title, "font-size=\"16\" font-weight=\"bold\"");
}

void draw_lines(SvgDrawing& drawing, const ChartSeries& series, const char* colour, const Axis& x, const Axis& y) {
  std::map<std::string, std::vector<std::array<double, 2>>> lines;
  for (const ChartPoint& point : series.points)
    if (!point.line.empty()) lines[point.line].push_back({x.at(point.x), y.at(point.y)});
  for (auto& [name, points] : lines) {
    std::ranges::sort(points);
    drawing.add_path(points, colour);
  }
}

void draw(SvgDrawing& drawing, const ChartSeries& series, std::size_t i, const Axis& x, const Axis& y) {
  draw_lines(drawing, series, colour_of(i), x, y);
  for (const ChartPoint& point : series.points)
    drawing.add_marker(x.at(point.x), y.at(point.y), i, series.name + ", " + point.name);
  const double legend_y = chart_top + 10 + legend_step * static_cast<double>(i);
  drawing.add_marker(chart_right + 24, legend_y, i, series.name);
  drawing.add_text(chart_right + 36, legend_y + 4, "start", series.name);
}

/// The series, with only the points that can be drawn.
std::vector<ChartSeries> drawable(const std::vector<ChartSeries>& all) {
  std::vector<ChartSeries> result;
  for (ChartSeries series : all) {
    std::erase_if(series.points, [](const ChartPoint& point) { return !(point.x > 0 && point.y > 0); });
    if (!series.points.empty()) result.push_back(std::move(series));
  }
  return result;
}

std::vector<double> values_of(const std::vector<ChartSeries>& all, double ChartPoint::*member) {
  std::vector<double> values;
  for (const ChartSeries& series : all)
    for (const ChartPoint& point : series.points) values.push_back(point.*member);
  return values;
}

Axis axis_around(const std::vector<double>& values, double begin, double end) {
  const auto [low, high] = std::ranges::minmax(values);
  return {ticks_around(low, high), begin, end};
}

}  // namespace

std::string to_svg(const Chart& chart) {
  const std::vector<ChartSeries> all = drawable(chart.series);
  if (all.empty()) return {};
  const Axis x = axis_around(values_of(all, &ChartPoint::x), chart_left, chart_right);
  const Axis y = axis_around(values_of(all, &ChartPoint::y), chart_bottom, chart_top);
  SvgDrawing drawing(line_chart_width, line_chart_height);
  draw_axes(drawing, chart, x, y);
  for (std::size_t i = 0; i < all.size(); ++i) draw(drawing, all[i], i, x, y);
  return drawing.finished();
}

}  // namespace whittle::app
