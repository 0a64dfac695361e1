#include "bench/results/plots.hh"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/results/csv.hh"
#include "bench/results/statistics.hh"
#include "charts/svg_chart.hh"

namespace whittle::bench {
namespace {

using app::Chart;
using app::ChartPoint;
using app::ChartSeries;

constexpr std::string_view permuted_suffix = "/permuted";

/// The common part of the names of meshes that differ in size only: "sphere" of "sphere-70k".
std::string family_of(const std::string& mesh) {
  const std::size_t dash = mesh.rfind('-');
  return dash == std::string::npos ? mesh : mesh.substr(0, dash);
}

/// The different names, in order of first appearance.
std::vector<std::string> names_of(const std::vector<Row>& rows, std::string Row::*member) {
  std::vector<std::string> names;
  for (const Row& row : rows)
    if (std::ranges::find(names, row.*member) == names.end()) names.push_back(row.*member);
  return names;
}

/// \param point_of makes a point of a row, or std::nullopt
template <class PointOf>
std::vector<ChartSeries> series_of(const std::vector<Row>& rows, PointOf point_of) {
  std::vector<ChartSeries> all;
  for (const std::string& peer : names_of(rows, &Row::peer)) {
    ChartSeries series{peer, {}};
    for (const Row& row : rows) {
      if (row.peer != peer) continue;
      if (const std::optional<ChartPoint> point = point_of(row)) series.points.push_back(*point);
    }
    all.push_back(std::move(series));
  }
  return all;
}

Chart time_chart(const std::vector<Row>& rows, bool is_permuted, Clock clock) {
  const auto point_of = [&](const Row& row) -> std::optional<ChartPoint> {
    if (row.ms.empty() || row.mesh.ends_with(permuted_suffix) != is_permuted) return std::nullopt;
    const auto n_faces = static_cast<double>(row.n_faces);
    const std::string share = formatted(", %.3g %%", 100 * static_cast<double>(row.n_wanted) / n_faces);
    return ChartPoint{n_faces, spread_of(row.ms).median, row.mesh + share, family_of(row.mesh) + share};
  };
  return {std::string("Time to decimate") + (is_permuted ? ", vertices and faces in random order" : ""),
          "faces of the input", std::string("ms, median (") + to_string(clock) + " time)", series_of(rows, point_of)};
}

Chart error_chart(const std::vector<Row>& rows, const std::string& mesh) {
  constexpr double rounding = 1e-12;  // a flat mesh has no error to draw
  const auto point_of = [&](const Row& row) -> std::optional<ChartPoint> {
    if (row.mesh != mesh || !row.answer || row.answer->mean_error_rel.value_or(0) < rounding) return std::nullopt;
    const auto n_faces = static_cast<double>(row.answer->n_faces);
    return ChartPoint{n_faces, *row.answer->mean_error_rel, row.mesh, row.mesh};
  };
  return {"Error, " + mesh, "faces of the result", "mean distance / diagonal", series_of(rows, point_of)};
}

}  // namespace

std::vector<std::filesystem::path> write_plots(const std::filesystem::path& folder, const std::vector<Row>& rows,
                                               Clock clock) {
  std::filesystem::create_directories(folder);
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::string& name, const Chart& chart) {
    const std::string svg = app::to_svg(chart);
    if (svg.empty()) return;
    std::ofstream file(folder / name, std::ios::binary);
    file << svg << std::flush;
    if (!file) throw std::runtime_error("can't write " + (folder / name).string());
    files.push_back(folder / name);
  };
  add("time.svg", time_chart(rows, false, clock));
  add("time-permuted.svg", time_chart(rows, true, clock));
  for (const std::string& mesh : names_of(rows, &Row::mesh))
    if (!mesh.ends_with(permuted_suffix)) add("error-" + mesh + ".svg", error_chart(rows, mesh));
  return files;
}

}  // namespace whittle::bench
