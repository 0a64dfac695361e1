#include "commands/page/page_charts.hh"

#include <algorithm>
#include <map>
#include <utility>

#include "charts/bar_chart.hh"
#include "terminal/table.hh"

namespace whittle::app {
namespace {

void add(std::vector<report::PageChart>& charts, const std::string& title, std::string svg) {
  if (!svg.empty()) charts.push_back({title, std::move(svg)});
}

BarChart error_chart(const std::vector<PageMesh>& meshes) {
  constexpr std::size_t n_parts = 16;
  BarChart chart{"", "distance, model units", {}, {}};
  double max = 0;
  for (const PageMesh& mesh : meshes) max = std::max(max, mesh.distances ? mesh.distances->max : 0.0);
  for (std::size_t i = 0; i < n_parts; ++i) {
    const double end = max * static_cast<double>(i + 1) / static_cast<double>(n_parts);
    chart.categories.push_back(i % 4 == 3 ? "to " + significant(end) : "");
  }
  for (const PageMesh& mesh : meshes) {
    if (mesh.distances) chart.series.push_back({mesh.name, distance_histogram(*mesh.distances, max, n_parts)});
  }
  return chart;
}

BarChart valence_chart(const std::vector<PageMesh>& meshes) {
  constexpr std::size_t least = 3;
  constexpr std::size_t most = 12;
  BarChart chart{"", "edges at a vertex inside", {}, {}};
  for (std::size_t valence = least; valence <= most; ++valence) {
    const std::string ending = valence == least ? " or less" : valence == most ? " or more" : "";
    chart.categories.push_back(std::to_string(valence) + ending);
  }
  for (const PageMesh& mesh : meshes) {
    BarSeries series{mesh.name, std::vector<double>(chart.categories.size(), 0.0)};
    for (const auto& [valence, n] : mesh.shape.valence.histogram) {
      series.shares[std::clamp(valence, least, most) - least] +=
          static_cast<double>(n) / static_cast<double>(mesh.shape.valence.vertices);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

BarChart shape_chart(const std::vector<PageMesh>& meshes) {
  BarChart chart{"", "radius ratio 2r/R, 1 is equilateral", {}, {}};
  for (const PageMesh& mesh : meshes) {
    BarSeries series{mesh.name, {}};
    double total = 0;
    for (const std::size_t n : mesh.shape.radius_ratio_histogram) total += static_cast<double>(n);
    for (const std::size_t n : mesh.shape.radius_ratio_histogram) {
      series.shares.push_back(static_cast<double>(n) / total);
    }
    chart.series.push_back(std::move(series));
  }
  const std::size_t n_parts = chart.series.front().shares.size();
  for (std::size_t i = 0; i < n_parts; ++i) {
    const double end = static_cast<double>(i + 1) / static_cast<double>(n_parts);
    chart.categories.push_back(i % 4 == 3 ? "to " + significant(end) : "");
  }
  return chart;
}

}  // namespace

std::vector<report::PageChart> page_charts(const std::vector<PageMesh>& meshes, const std::vector<CurvePoint>& curve) {
  std::vector<report::PageChart> charts;
  if (!curve.empty()) add(charts, "Faces and error on the way", curve_svg(curve, "the recording"));
  const BarChart errors = error_chart(meshes);
  if (!errors.series.empty()) add(charts, "How much of the surface is how far off", to_svg(errors));
  add(charts, "Valence", to_svg(valence_chart(meshes)));
  add(charts, "Triangle shape", to_svg(shape_chart(meshes)));
  return charts;
}

}  // namespace whittle::app
