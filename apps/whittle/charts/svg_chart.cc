#include "charts/svg_chart.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <map>
#include <sstream>

namespace whittle::app {
namespace {

// Pixels.
constexpr double width = 920;
constexpr double height = 520;
constexpr double left = 80;
constexpr double right = 690;  // the legend is to the right of it
constexpr double top = 50;
constexpr double bottom = 460;
constexpr double legend_step = 22;

// The colours of Okabe and Ito, for the colour-blind. Yellow is left out: it can't be seen on white.
constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#888888"};

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

/// \param format printf format for a double
std::string formatted(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

/// Collects the elements of a drawing as text. Coordinates have one decimal.
class Drawing {
 public:
  Drawing() {
    out_ << std::fixed << std::setprecision(1);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
         << "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#888\">\n";
  }

  /// \param anchor "start", "middle" or "end". \param attributes further ones
  void add_text(double x, double y, const char* anchor, const std::string& text, const std::string& attributes = {}) {
    out_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\" " << attributes << '>'
         << escaped(text) << "</text>\n";
  }

  void add_grid_line(double x0, double y0, double x1, double y1) {
    out_ << "<line x1=\"" << x0 << "\" y1=\"" << y0 << "\" x2=\"" << x1 << "\" y2=\"" << y1
         << "\" stroke=\"#888\" stroke-opacity=\"0.3\"/>\n";
  }

  void add_path(const std::vector<std::array<double, 2>>& points, const char* colour) {
    out_ << "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"" << colour << "\" points=\"";
    for (const auto& [x, y] : points) out_ << x << ',' << y << ' ';
    out_ << "\"/>\n";
  }

  /// A square, a diamond, a triangle, or an inverted triangle. \param title tooltip
  void add_marker(double x, double y, std::size_t series, const std::string& title) {
    constexpr double m = 5;
    using Corners = std::vector<std::array<double, 2>>;
    static const std::array<Corners, 4> shapes = {
        Corners{{-m, -m}, {m, -m}, {m, m}, {-m, m}}, Corners{{0, -1.4 * m}, {1.4 * m, 0}, {0, 1.4 * m}, {-1.4 * m, 0}},
        Corners{{0, -1.2 * m}, {1.2 * m, m}, {-1.2 * m, m}}, Corners{{0, 1.2 * m}, {1.2 * m, -m}, {-1.2 * m, -m}}};
    out_ << "<polygon fill=\"" << colours[series % colours.size()] << "\" points=\"";
    for (const auto& [dx, dy] : shapes[series % shapes.size()]) out_ << x + dx << ',' << y + dy << ' ';
    out_ << "\"><title>" << escaped(title) << "</title></polygon>\n";
  }

  std::string finished() const { return out_.str() + "</svg>\n"; }

 private:
  std::ostringstream out_;
};

void draw_axes(Drawing& drawing, const Chart& chart, const Axis& x, const Axis& y) {
  for (const double tick : x.ticks) {
    drawing.add_grid_line(x.at(tick), top, x.at(tick), bottom);
    drawing.add_text(x.at(tick), bottom + 18, "middle", formatted("%.7g", tick));
  }
  for (const double tick : y.ticks) {
    drawing.add_grid_line(left, y.at(tick), right, y.at(tick));
    drawing.add_text(left - 8, y.at(tick) + 4, "end", formatted("%.4g", tick));
  }
  drawing.add_text((left + right) / 2, bottom + 44, "middle", chart.x_label);
  drawing.add_text(-(top + bottom) / 2, 18, "middle", chart.y_label, "transform=\"rotate(-90)\"");
  drawing.add_text(left, top - 20, "start", chart.title, "font-size=\"16\" font-weight=\"bold\"");
}

void draw_lines(Drawing& drawing, const ChartSeries& series, const char* colour, const Axis& x, const Axis& y) {
  std::map<std::string, std::vector<std::array<double, 2>>> lines;
  for (const ChartPoint& point : series.points)
    if (!point.line.empty()) lines[point.line].push_back({x.at(point.x), y.at(point.y)});
  for (auto& [name, points] : lines) {
    std::ranges::sort(points);
    drawing.add_path(points, colour);
  }
}

void draw(Drawing& drawing, const ChartSeries& series, std::size_t i, const Axis& x, const Axis& y) {
  draw_lines(drawing, series, colours[i % colours.size()], x, y);
  for (const ChartPoint& point : series.points)
    drawing.add_marker(x.at(point.x), y.at(point.y), i, series.name + ", " + point.name);
  const double legend_y = top + 10 + legend_step * static_cast<double>(i);
  drawing.add_marker(right + 24, legend_y, i, series.name);
  drawing.add_text(right + 36, legend_y + 4, "start", series.name);
}

/// The series, with only those points that can be drawn.
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
  const Axis x = axis_around(values_of(all, &ChartPoint::x), left, right);
  const Axis y = axis_around(values_of(all, &ChartPoint::y), bottom, top);
  Drawing drawing;
  draw_axes(drawing, chart, x, y);
  for (std::size_t i = 0; i < all.size(); ++i) draw(drawing, all[i], i, x, y);
  return drawing.finished();
}

}  // namespace whittle::app
