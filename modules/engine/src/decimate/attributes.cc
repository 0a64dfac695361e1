#include "whittle/engine/attributes.hh"

#include <array>
#include <cmath>

#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {
namespace {

/// The sum of an attribute over the vertices merged into each vertex of the result, and their number.
template <std::size_t N>
struct MergedSum {
  MergedSum(const std::vector<std::array<float, N>>& values, const std::vector<Index>& vertex_map,
            std::size_t n_vertices)
      : sums(n_vertices), counts(n_vertices) {
    for (std::size_t v = 0; v < vertex_map.size(); ++v) {
      if (vertex_map[v] == invalid_index) continue;
      for (std::size_t i = 0; i < N; ++i) sums[vertex_map[v]][i] += values[v][i];
      ++counts[vertex_map[v]];
    }
  }

  std::vector<std::array<double, N>> sums;
  std::vector<std::size_t> counts;
};

/// The mean colour of the vertices merged into each vertex of the result.
std::vector<Color> merged_colors(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                 std::size_t n_vertices) {
  const MergedSum<4> merged(input.colors, vertex_map, n_vertices);
  std::vector<Color> colors(n_vertices);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      colors[v][channel] = static_cast<float>(merged.sums[v][channel] / static_cast<double>(merged.counts[v]));
    }
  }
  return colors;
}

/// The mean direction of the normals merged into each vertex of `mesh`, the result. Where they cancel out it is that of
/// the faces of `mesh`.
std::vector<std::array<float, 3>> merged_normals(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                                 const IndexedMesh& mesh, const Frame& frame) {
  constexpr double least_mean = 1e-3;  // below that the mean of unit vectors has no direction to speak of
  const MergedSum<3> merged(input.normals, vertex_map, mesh.positions.size());
  std::vector<std::array<float, 3>> normals = vertex_normals(mesh, frame);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const auto& sum = merged.sums[v];
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const bool is_alone = merged.counts[v] == 1;  // then it keeps every bit
    if (!is_alone && !(length >= least_mean * static_cast<double>(merged.counts[v]))) continue;
    for (std::size_t i = 0; i < 3; ++i) normals[v][i] = static_cast<float>(is_alone ? sum[i] : sum[i] / length);
  }
  return normals;
}

std::vector<std::array<float, 3>> output_normals(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                                 const IndexedMesh& mesh, const Frame& frame, Normals normals) {
  if (input.normals.empty() || normals == Normals::drop) return {};
  return normals == Normals::keep ? merged_normals(input, vertex_map, mesh, frame) : vertex_normals(mesh, frame);
}

}  // namespace

void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals,
                      const std::vector<Index>& vertex_map, IndexedMesh& mesh) {
  if (!input.colors.empty()) mesh.colors = merged_colors(input, vertex_map, mesh.positions.size());
  mesh.normals = output_normals(input, vertex_map, mesh, frame, normals);
}

}  // namespace whittle
