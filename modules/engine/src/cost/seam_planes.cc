#include "cost/seam_planes.hh"

#include <algorithm>
#include <array>

#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {
namespace {

/// Edges that are held by planes of a weight.
struct HeldEdges {
  std::span<const VertexPair> edges;  ///< ascending
  QuadricOptions options;
};

std::vector<Index> ends_of(std::span<const HeldEdges> all) {
  std::vector<Index> vertices;
  for (const HeldEdges& held : all) {
    for (const auto& [a, b] : held.edges) vertices.insert(vertices.end(), {a, b});
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

std::vector<VertexQuadric> seam_planes(const IndexedMesh& mesh, const Frame& frame, std::span<const VertexPair> seams,
                                       std::span<const VertexPair> folds, const DecimateOptions& options) {
  std::array<HeldEdges, 2> all{HeldEdges{seams, options.quadric}, HeldEdges{folds, options.quadric}};
  all[0].options.boundary_weight = options.attribute_weights.seam;
  if (seams.empty() && folds.empty()) return {};
  std::vector<VertexQuadric> planes;
  std::vector<Index> place_of(mesh.positions.size(), invalid_index);
  for (const Index v : ends_of(all)) {
    place_of[v] = static_cast<Index>(planes.size());
    planes.push_back({v, {}});
  }
  const auto at = [&](Index v) { return frame.to_frame(mesh.positions[v]); };
  const auto add = [&](Index v, Index from, Index to, Index opposite) {
    const auto [low, high] = std::minmax(from, to);
    for (const HeldEdges& held : all) {
      if (!std::binary_search(held.edges.begin(), held.edges.end(), VertexPair{low, high})) continue;
      planes[place_of[v]].quadric.a += border_quadric(at(from), at(to), at(opposite), held.options);
    }
  };
  for (const Triangle& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = face[k];
      const Index next = face[(k + 1) % 3];
      const Index previous = face[(k + 2) % 3];
      if (place_of[v] == invalid_index) continue;
      if (place_of[next] != invalid_index) add(v, v, next, previous);
      if (place_of[previous] != invalid_index) add(v, previous, v, next);
    }
  }
  return planes;
}

}  // namespace whittle
