#include "charts/svg_drawing.hh"

#include <cstdio>
#include <iomanip>

namespace whittle::app {
namespace {

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

}  // namespace

const char* colour_of(std::size_t series) {
  // The colours of Okabe and Ito. Yellow is left out: it can't be seen on white.
  constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#888888"};
  return colours[series % colours.size()];
}

std::string formatted(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

SvgDrawing::SvgDrawing(double width, double height) {
  out_ << std::fixed << std::setprecision(1);
  out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
       << "\" viewBox=\"0 0 " << width << ' ' << height
       << "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#888\">\n";
}

void SvgDrawing::add_text(double x, double y, const char* anchor, const std::string& text,
                          const std::string& attributes) {
  out_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\" " << attributes << '>'
       << escaped(text) << "</text>\n";
}

void SvgDrawing::add_grid_line(double x0, double y0, double x1, double y1) {
  out_ << "<line x1=\"" << x0 << "\" y1=\"" << y0 << "\" x2=\"" << x1 << "\" y2=\"" << y1
       << "\" stroke=\"#888\" stroke-opacity=\"0.3\"/>\n";
}

void SvgDrawing::add_path(const std::vector<std::array<double, 2>>& points, const char* colour) {
  out_ << "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"" << colour << "\" points=\"";
  for (const auto& [x, y] : points) out_ << x << ',' << y << ' ';
  out_ << "\"/>\n";
}

void SvgDrawing::add_marker(double x, double y, std::size_t series, const std::string& title) {
  constexpr double m = 5;
  using Corners = std::vector<std::array<double, 2>>;
  static const std::array<Corners, 4> shapes = {
      Corners{{-m, -m}, {m, -m}, {m, m}, {-m, m}}, Corners{{0, -1.4 * m}, {1.4 * m, 0}, {0, 1.4 * m}, {-1.4 * m, 0}},
      Corners{{0, -1.2 * m}, {1.2 * m, m}, {-1.2 * m, m}}, Corners{{0, 1.2 * m}, {1.2 * m, -m}, {-1.2 * m, -m}}};
  out_ << "<polygon fill=\"" << colour_of(series) << "\" points=\"";
  for (const auto& [dx, dy] : shapes[series % shapes.size()]) out_ << x + dx << ',' << y + dy << ' ';
  out_ << "\"><title>" << escaped(title) << "</title></polygon>\n";
}

void SvgDrawing::add_bar(double x, double y, double width, double height, std::size_t series,
                         const std::string& title) {
  out_ << "<rect fill=\"" << colour_of(series) << "\" x=\"" << x << "\" y=\"" << y << "\" width=\"" << width
       << "\" height=\"" << height << "\"><title>" << escaped(title) << "</title></rect>\n";
}

}  // namespace whittle::app
