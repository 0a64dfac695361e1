#include "charts/bar_chart.hh"

#include <algorithm>
#include <cmath>

#include "charts/svg_drawing.hh"

namespace whittle::app {
namespace {

// Pixels.
constexpr double chart_width = 640;
constexpr double plot_left = 60;
constexpr double plot_right = 620;
constexpr double plot_top = 40;
constexpr double plot_bottom = 300;
constexpr double legend_row = 20;

/// A round number at or above the largest share, and the number of parts of the axis.
struct ShareAxis {
  double end;
  int n_parts;

  double at(double share) const { return plot_bottom + (plot_top - plot_bottom) * share / end; }
};

ShareAxis axis_of(const BarChart& chart) {
  double most = 0.01;
  for (const BarSeries& series : chart.series) {
    for (const double share : series.shares) most = std::max(most, share);
  }
  for (const double step : {0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2}) {
    const double n_parts = std::ceil(most / step);
    if (n_parts <= 5) return {n_parts * step, static_cast<int>(n_parts)};
  }
  return {1, 5};
}

void draw_axes(SvgDrawing& drawing, const BarChart& chart, const ShareAxis& axis) {
  for (int i = 0; i <= axis.n_parts; ++i) {
    const double share = axis.end * i / axis.n_parts;
    drawing.add_grid_line(plot_left, axis.at(share), plot_right, axis.at(share));
    drawing.add_text(plot_left - 8, axis.at(share) + 4, "end", formatted("%.3g %%", 100 * share));
  }
  const double step = (plot_right - plot_left) / static_cast<double>(chart.categories.size());
  for (std::size_t i = 0; i < chart.categories.size(); ++i) {
    drawing.add_text(plot_left + (static_cast<double>(i) + 0.5) * step, plot_bottom + 18, "middle",
                     chart.categories[i]);
  }
  drawing.add_text((plot_left + plot_right) / 2, plot_bottom + 40, "middle", chart.x_label);
  drawing.add_text(plot_left, plot_top - 16, "start", chart.title, "font-size=\"15\" font-weight=\"bold\"");
}

void draw_bars(SvgDrawing& drawing, const BarChart& chart, const ShareAxis& axis) {
  constexpr double filled = 0.86;  // of a category's width
  const double step = (plot_right - plot_left) / static_cast<double>(chart.categories.size());
  const double bar = filled * step / static_cast<double>(chart.series.size());
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    const BarSeries& series = chart.series[s];
    for (std::size_t i = 0; i < chart.categories.size(); ++i) {
      const double x = plot_left + (static_cast<double>(i) + (1 - filled) / 2) * step + static_cast<double>(s) * bar;
      const double y = axis.at(series.shares[i]);
      drawing.add_bar(x, y, bar, plot_bottom - y, s, series.name + ": " + formatted("%.3g %%", 100 * series.shares[i]));
    }
    const double legend_y = plot_bottom + 62 + legend_row * static_cast<double>(s);
    drawing.add_bar(plot_left, legend_y - 9, 12, 10, s, series.name);
    drawing.add_text(plot_left + 20, legend_y, "start", series.name);
  }
}

}  // namespace

std::string to_svg(const BarChart& chart) {
  if (chart.series.empty() || chart.categories.empty()) return {};
  SvgDrawing drawing(chart_width, plot_bottom + 70 + legend_row * static_cast<double>(chart.series.size()));
  const ShareAxis axis = axis_of(chart);
  draw_axes(drawing, chart, axis);
  draw_bars(drawing, chart, axis);
  return drawing.finished();
}

}  // namespace whittle::app
