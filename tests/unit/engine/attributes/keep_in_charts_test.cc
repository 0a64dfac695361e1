// Faces that lie over another chart on a texture are drawn back into theirs.
#include "whittle/core/keep_in_charts.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

constexpr int n_chart_squares = 16;
constexpr double chart_gap = 0.1;

/// Two grids of one size, side by side on the image with a gap between.
struct TwoCharts {
  IndexedMesh original = joined(grid(n_chart_squares, n_chart_squares), grid(n_chart_squares, n_chart_squares));
  std::vector<double> values;  ///< of the original
  std::vector<Index> wedge_map;

  TwoCharts() {
    for (Index v = 0; v < original.positions.size(); ++v) {
      values.push_back(original.positions[v].x() + (is_left(v) ? 0 : n_chart_squares + chart_gap));
      values.push_back(original.positions[v].y());
    }
    wedge_map.resize(original.positions.size());
    std::iota(wedge_map.begin(), wedge_map.end(), Index{0});
  }

  bool is_left(Index v) const { return v < original.positions.size() / 2; }
  MovedTexture texture() const { return {original, values, wedge_map, 2, original.faces}; }

  /// The wedges of the left chart at its right side.
  std::vector<Index> border() const {
    std::vector<Index> wedges;
    for (Index v = 0; is_left(v); ++v) {
      if (original.positions[v].x() == n_chart_squares) wedges.push_back(v);
    }
    return wedges;
  }
  /// The coordinates, with every other wedge of that side in the chart beyond.
  std::vector<double> sticking_out(double by) const {
    std::vector<double> moved = values;
    for (const Index w : border()) moved[2 * w] += w % 2 == 0 ? by : 0;
    return moved;
  }
};

TEST(KeepInCharts, DrawsBackWhatSticksOut) {
  const TwoCharts charts;
  std::vector<double> moved = charts.sticking_out(0.4);
  const std::vector<double> before = moved;
  EXPECT_EQ(keep_in_charts(charts.texture(), moved), 0U);
  for (const Index w : charts.border())
    EXPECT_LE(moved[2 * w], n_chart_squares + chart_gap + 0.02) << "but for a hundredth";
  for (Index w = 0; w < charts.original.positions.size(); ++w) {
    if (charts.is_left(w) && charts.original.positions[w].x() > n_chart_squares - 2) continue;
    EXPECT_EQ(moved[2 * w], before[2 * w]) << "what lies elsewhere stays";
    EXPECT_EQ(moved[2 * w + 1], before[2 * w + 1]);
  }
}

TEST(KeepInCharts, LeavesWhatIsRight) {
  const TwoCharts charts;
  std::vector<double> moved = charts.sticking_out(0.05);  // in the gap
  const std::vector<double> before = moved;
  EXPECT_EQ(keep_in_charts(charts.texture(), moved), 0U);
  EXPECT_EQ(moved, before);
}

TEST(KeepInCharts, LeavesChartsThatShareTheirImage) {
  TwoCharts charts;
  for (Index v = 0; v < charts.original.positions.size(); ++v) {
    if (!charts.is_left(v))
      charts.values[2 * v] = n_chart_squares - charts.original.positions[v].x();  // mirrored, on the first
  }
  std::vector<double> moved = charts.values;
  EXPECT_EQ(keep_in_charts(charts.texture(), moved), 0U);
  EXPECT_EQ(moved, charts.values);
}

TEST(KeepInCharts, LeavesOtherImagesAlone) {
  TwoCharts charts;
  charts.original.group_names = {"left", "right"};
  charts.original.face_groups.assign(charts.original.faces.size(), 0);
  for (std::size_t f = charts.original.faces.size() / 2; f < charts.original.faces.size(); ++f) {
    charts.original.face_groups[f] = 1;
  }
  std::vector<double> moved = charts.sticking_out(0.4);
  const std::vector<double> before = moved;
  EXPECT_EQ(keep_in_charts(charts.texture(), moved), 0U);
  EXPECT_EQ(moved, before);
}

TEST(KeepInCharts, LeavesChartsOfOneMap) {
  const TwoCharts charts;
  std::vector<double> moved = charts.sticking_out(0.4);
  const std::vector<double> before = moved;
  const std::vector<Index> maps(charts.original.positions.size(), 0);
  MovedTexture texture = charts.texture();
  texture.maps = maps;
  EXPECT_EQ(keep_in_charts(texture, moved), 0U);
  EXPECT_EQ(moved, before);
}

/// A chart for each face, of which a face of the result has many under it.
TEST(KeepInCharts, LeavesFacesThatAreLargerThanTheirCharts) {
  const IndexedMesh original = soup(grid(n_chart_squares, n_chart_squares));
  std::vector<double> values;
  for (const Vec3& p : original.positions) values.insert(values.end(), {p.x(), p.y()});
  std::vector<Index> wedge_map(original.positions.size(), invalid_index);
  const std::vector<Triangle> faces{{0, 1, 2}};
  for (Index w = 0; w < 3; ++w) wedge_map[w] = w;
  std::vector<double> large{0, 0, n_chart_squares, 0, 0, n_chart_squares};
  const std::vector<double> before = large;
  EXPECT_EQ(keep_in_charts({original, values, wedge_map, 2, faces}, large), 1U);
  EXPECT_EQ(large, before);
}

TEST(KeepInCharts, LeavesNumbersThatAreNotFinite) {
  const TwoCharts charts;
  std::vector<double> moved = charts.sticking_out(0.4);
  moved[0] = std::numeric_limits<double>::infinity();
  const std::vector<double> before = moved;
  EXPECT_EQ(keep_in_charts(charts.texture(), moved), 0U);
  EXPECT_EQ(moved, before);
}

TEST(KeepInCharts, IsTheSameOnAnyNumberOfThreads) {
  const TwoCharts charts;
  std::vector<double> one = charts.sticking_out(0.4);
  std::vector<double> three = one;
  MovedTexture texture = charts.texture();
  texture.threads = 1;
  keep_in_charts(texture, one);
  texture.threads = 3;
  keep_in_charts(texture, three);
  EXPECT_EQ(one, three);
}

}  // namespace
}  // namespace whittle::test
