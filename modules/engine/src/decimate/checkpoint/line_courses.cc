#include "decimate/checkpoint/line_courses.hh"

#include <algorithm>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/geometry/segment.hh"

namespace whittle {
namespace {

/// Each once, ascending.
std::vector<Index> vertices_of(std::span<const VertexPair> edges) {
  std::vector<Index> vertices;
  for (const auto& [a, b] : edges) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

void find_courses(const IndexedMesh& input, const Frame& frame, std::span<const VertexPair> features,
                  WorkingSurface& surface) {
  FeatureLines& lines = surface.lines;
  const detail::IndexLists<Index> edges_at(surface.positions.size(), [&](const auto& add) {
    for (Index e = 0; e < lines.edges.size(); ++e) {
      if (!lines.is_seam.empty() && lines.is_seam[e] != 0) continue;
      add(lines.edges[e].a, e);
      add(lines.edges[e].b, e);
    }
  });
  lines.courses.assign(lines.edges.size(), {});
  for (const Index v : vertices_of(features)) {
    const Index end = surface.vertex_map[v];
    if (end == invalid_index || edges_at.of(end).empty()) continue;
    const Vec3 point = frame.to_frame(input.positions[v]);
    const auto distance_to = [&](Index e) {
      return distance_sq_to_segment(point, surface.positions[lines.edges[e].a], surface.positions[lines.edges[e].b]);
    };
    const std::span<const Index> edges = edges_at.of(end);
    const Index nearest = *std::min_element(edges.begin(), edges.end(),
                                            [&](Index e, Index f) { return distance_to(e) < distance_to(f); });
    lines.courses[nearest].push_back(point);
  }
}

}  // namespace whittle
