#include "charts.hh"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::bake {

namespace {

constexpr double least_cosine = 0.5;  // 60°: a projected face has at least half its area

/// Per face its neighbours across regular edges; `invalid_index` where there is none.
std::vector<std::array<Index, 3>> neighbours_of(const std::vector<Triangle>& faces, std::size_t n_vertices) {
  std::vector<std::array<Index, 3>> neighbours(faces.size(), {invalid_index, invalid_index, invalid_index});
  const detail::EdgeTable edges(faces, n_vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_regular(e, faces)) continue;
    const auto sides = edges.sides(e);
    neighbours[detail::face_of(sides[0])][sides[0] % 3] = detail::face_of(sides[1]);
    neighbours[detail::face_of(sides[1])][sides[1] % 3] = detail::face_of(sides[0]);
  }
  return neighbours;
}

class ChartMaker {
 public:
  ChartMaker(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces)
      : neighbours_(neighbours_of(faces, positions.size())), area_normals_(faces.size()), round_(faces.size(), 0) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      area_normals_[f] = reliable_normal(positions[faces[f][0]], positions[faces[f][1]], positions[faces[f][2]]);
    }
  }

  std::vector<Chart> charts() {
    std::vector<Index> seeds(area_normals_.size());
    std::iota(seeds.begin(), seeds.end(), Index{0});
    std::stable_sort(seeds.begin(), seeds.end(), [this](Index a, Index b) {
      return area_normals_[a].squaredNorm() > area_normals_[b].squaredNorm();
    });
    std::vector<Chart> charts;
    for (const Index seed : seeds) {
      if (round_[seed] == taken) continue;
      charts.push_back(chart_from(seed));
      for (const Index f : charts.back().faces) round_[f] = taken;
    }
    return charts;
  }

 private:
  static constexpr std::uint32_t taken = ~std::uint32_t{0};

  /// Grows a chart, turns its axis to the mean of its faces, and grows it anew.
  Chart chart_from(Index seed) {
    constexpr int n_rounds = 3;
    const Vec3 normal = area_normals_[seed].normalized();
    Chart chart{normal.isZero(0) ? Vec3::UnitZ() : normal, {}};
    for (int round = 1;; ++round) {
      chart.faces = grown(seed, chart.axis);
      if (round == n_rounds) return chart;
      Vec3 mean = Vec3::Zero();
      for (const Index f : chart.faces) mean += area_normals_[f];
      mean.normalize();
      if (!(mean.dot(normal) > least_cosine)) return chart;
      chart.axis = mean;
    }
  }

  /// The faces connected with the seed that belong to no chart yet and face the axis. Faces without area do.
  std::vector<Index> grown(Index seed, const Vec3& axis) {
    ++n_rounds_;
    std::vector<Index> faces{seed};
    round_[seed] = n_rounds_;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (const Index next : neighbours_[faces[i]]) {
        if (next == invalid_index || round_[next] == taken || round_[next] == n_rounds_) continue;
        const Vec3& normal = area_normals_[next];
        if (!normal.isZero(0) && !(normal.dot(axis) > least_cosine * normal.norm())) continue;
        round_[next] = n_rounds_;
        faces.push_back(next);
      }
    }
    return faces;
  }

  std::vector<std::array<Index, 3>> neighbours_;
  std::vector<Vec3> area_normals_;
  std::vector<std::uint32_t> round_;  ///< Per face, the last round that reached it, or `taken`.
  std::uint32_t n_rounds_ = 0;
};

}  // namespace

std::vector<Chart> make_charts(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces) {
  return ChartMaker(positions, faces).charts();
}

}  // namespace whittle::bake
