// Each face enters its three edges in the list of their lower vertex; the short lists are then sorted one by one.
#include "edges.hh"

#include <algorithm>
#include <cstdint>

#include "triangle_math.hh"

namespace whittle::metrics {

EdgeTable::EdgeTable(const IndexedMesh& mesh) {
  struct Side {
    Index high, face;
    bool operator<(const Side& other) const { return high != other.high ? high < other.high : face < other.face; }
  };
  const std::size_t n_vertices = mesh.positions.size();
  const auto for_each_side = [&mesh](const auto& visit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Triangle& face = mesh.faces[f];
      if (is_collapsed(face)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] = std::minmax(face[c], face[(c + 1) % 3]);
        visit(low, high, static_cast<Index>(f));
      }
    }
  };

  std::vector<std::size_t> begin(n_vertices + 1, 0);
  for_each_side([&](Index low, Index, Index) { ++begin[low + std::size_t{1}]; });
  for (std::size_t v = 0; v < n_vertices; ++v) begin[v + 1] += begin[v];
  std::vector<Side> sides(begin[n_vertices]);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_side([&](Index low, Index high, Index face) { sides[next[low]++] = {high, face}; });

  faces_.reserve(sides.size());
  edges_.reserve(sides.size() / 2 + 1);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    const auto first = sides.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    const auto last = sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(first, last);
    for (auto side = first; side != last; ++side) {
      if (side == first || side->high != (side - 1)->high) {
        edges_.push_back({static_cast<Index>(v), side->high, faces_.size()});
      }
      faces_.push_back(side->face);
    }
  }
  edges_.push_back({invalid_index, invalid_index, faces_.size()});
}

std::optional<std::array<Vec3, 2>> normals_at(const IndexedMesh& mesh, const EdgeTable& edges, std::size_t edge) {
  const auto faces = edges.faces(edge);
  if (faces.size() != 2) return std::nullopt;
  std::array<Vec3, 2> normals;
  for (std::size_t i = 0; i < 2; ++i) {
    const Triangle& face = mesh.faces[faces[i]];
    normals[i] =
        trusted_normal(mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]).stableNormalized();
    if (normals[i].isZero(0.0)) return std::nullopt;
    if (runs_along(face, edges[edge].low, edges[edge].high) != (i == 0)) normals[i] = -normals[i];
  }
  return normals;
}

}  // namespace whittle::metrics
