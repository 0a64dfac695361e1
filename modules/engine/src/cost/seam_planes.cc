#include "cost/seam_planes.hh"

#include <algorithm>
#include <array>

#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {
namespace {

std::vector<Index> ends_of(std::span<const VertexPair> edges) {
  std::vector<Index> vertices;
  for (const auto& [a, b] : edges) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

std::vector<Memory::Remembered> seam_planes(const IndexedMesh& mesh, const Frame& frame,
                                            std::span<const VertexPair> seams, const DecimateOptions& options) {
  if (seams.empty()) return {};
  std::vector<Memory::Remembered> planes;
  std::vector<Index> place_of(mesh.positions.size(), invalid_index);
  for (const Index v : ends_of(seams)) {
    place_of[v] = static_cast<Index>(planes.size());
    planes.push_back({v, {}});
  }
  QuadricOptions of_seams = options.quadric;
  of_seams.boundary_weight = options.attribute_weights.seam;
  const auto is_seam = [&](Index v, Index w) {
    if (place_of[v] == invalid_index || place_of[w] == invalid_index) return false;
    const auto [low, high] = std::minmax(v, w);
    return std::binary_search(seams.begin(), seams.end(), VertexPair{low, high});
  };
  for (const Triangle& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = face[k];
      if (place_of[v] == invalid_index) continue;
      const Index next = face[(k + 1) % 3];
      const Index previous = face[(k + 2) % 3];
      const auto at = [&](Index w) { return frame.to_frame(mesh.positions[w]); };
      SymmetricMatrix& sum = planes[place_of[v]].quadric.a;
      if (is_seam(v, next)) sum += border_quadric(at(v), at(next), at(previous), of_seams);
      if (is_seam(previous, v)) sum += border_quadric(at(previous), at(v), at(next), of_seams);
    }
  }
  return planes;
}

}  // namespace whittle
